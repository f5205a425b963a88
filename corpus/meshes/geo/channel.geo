// A channel with a wavy floor: periodic in x (so the file has $Periodic), with physical names, points and curves.
If (!Exists(h)) h = 0.7; EndIf
SetFactory("Built-in");
Point(1) = {0, 0, 0, h};  Point(2) = {2, 0, 0, h};  Point(3) = {2, 1, 0, h};  Point(4) = {0, 1, 0, h};
Point(5) = {0.5, 0.4, 0, h};  Point(6) = {1, 0, 0, h};  Point(7) = {1.5, -0.4, 0, h};
Spline(1) = {1, 5, 6, 7, 2};
Line(2) = {2, 3};  Line(3) = {3, 4};  Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Periodic Curve{2} = {-4} Translate{2, 0, 0};
Physical Curve("wavy floor") = {1};
Physical Curve("inflow") = {4};
Physical Curve("outflow") = {2};
Physical Surface("fluid: $Nodes is only a name") = {1};
Mesh.HighOrderOptimize = 0;
