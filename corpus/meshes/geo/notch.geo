// A block of parts x parts transfinite quadrilaterals over a floor with a tall hump: quadrilaterals beside it fold.
If (!Exists(parts)) parts = 2; EndIf
SetFactory("Built-in");
Point(1) = {0, 0, 0};  Point(2) = {2, 0, 0};  Point(3) = {2, 1.8, 0};  Point(4) = {0, 1.8, 0};
Point(5) = {0.6, 0.1, 0};  Point(6) = {1, 1.3, 0};  Point(7) = {1.4, 0.1, 0};
Spline(1) = {1, 5, 6, 7, 2};
Line(2) = {2, 3};  Line(3) = {3, 4};  Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve{1:4} = parts + 1;
Transfinite Surface{1};
Recombine Surface{1};
Mesh.HighOrderOptimize = 0;
