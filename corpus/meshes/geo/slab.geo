// A slab whose bottom, a quarter disc, lies in z = 0; the file holds the bottom and the volume only.
SetFactory("Built-in");
h = 0.9;
Point(1) = {0, 0, 0, h};
Point(2) = {1, 0, 0, h};
Point(3) = {0, 1, 0, h};
Line(1) = {1, 2};
Circle(2) = {2, 1, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Extrude {0, 0, 0.75} { Surface{1}; }
Physical Surface("bottom, z = 0") = {1};
Physical Volume("slab") = {1};
Mesh.HighOrderOptimize = 0;
