// Symmetric aerofoil with the NACA 0012 thickness (closed trailing edge) as two splines, in a box.
If (!Exists(h)) h = 0.5; EndIf
SetFactory("Built-in");
stations[] = {0.01, 0.04, 0.1, 0.2, 0.35, 0.5, 0.7, 0.85};
Point(1) = {1, 0, 0, h};
Point(2) = {0, 0, 0, h};
upper[] = {}; lower[] = {};
For k In {0:#stations[]-1}
  x = stations[k];
  y = 0.6 * (0.2969 * Sqrt(x) - 0.126 * x - 0.3516 * x^2 + 0.2843 * x^3 - 0.1036 * x^4);
  Point(10 + k) = {x, y, 0, h};
  Point(30 + k) = {x, -y, 0, h};
  upper[] += {10 + k};
  lower[] += {30 + k};
EndFor
Spline(1) = {2, upper[], 1};
Spline(2) = {2, lower[], 1};
Point(50) = {-0.5, -0.6, 0, h};  Point(51) = {1.5, -0.6, 0, h};
Point(52) = {1.5, 0.6, 0, h};    Point(53) = {-0.5, 0.6, 0, h};
Line(3) = {50, 51};  Line(4) = {51, 52};  Line(5) = {52, 53};  Line(6) = {53, 50};
Curve Loop(1) = {3, 4, 5, 6};
Curve Loop(2) = {-1, 2};
Plane Surface(1) = {1, 2};
If (Exists(parts))
  Transfinite Curve{1, 2} = parts + 1;
EndIf
If (Exists(quads))
  Recombine Surface{1};
EndIf
Mesh.HighOrderOptimize = 0;
