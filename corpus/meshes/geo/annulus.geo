// Annulus with radii 1 and r (default 4/5). Each ring quadrant gets `parts` divisions; coarse rings fold.
If (!Exists(r)) r = 0.8; EndIf
If (!Exists(parts)) parts = 1; EndIf
SetFactory("Built-in");
Point(9) = {0, 0, 0};
Point(1) = {1, 0, 0};  Point(2) = {0, 1, 0};  Point(3) = {-1, 0, 0};  Point(4) = {0, -1, 0};
Point(5) = {r, 0, 0};  Point(6) = {0, r, 0};  Point(7) = {-r, 0, 0};  Point(8) = {0, -r, 0};
For k In {1:4}
  next = k % 4 + 1;
  Circle(k) = {k, 9, next};
  Circle(4 + k) = {4 + k, 9, 4 + next};
  Line(8 + k) = {k, 4 + k};
EndFor
For k In {1:4}
  next = k % 4 + 1;
  Curve Loop(k) = {k, 8 + next, -(4 + k), -(8 + k)};
  Plane Surface(k) = {k};
EndFor
Transfinite Curve{1:8} = parts + 1;
Transfinite Curve{9:12} = 2;
Transfinite Surface{1:4};
If (Exists(quads))
  Recombine Surface{1:4};
EndIf
If (Exists(turned))
  ReverseMesh Surface{turned:4};
EndIf
Mesh.HighOrderOptimize = 0;
