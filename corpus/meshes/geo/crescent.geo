// Crescent through (0, 1) and (0, -1) between the unit circle and a circle through (a, 0), with its centre at (c, 0).
// Coarse on purpose: the chords of the outer arc come close to the inner one, or cross it.
If (!Exists(h)) h = 0.35; EndIf
If (!Exists(a)) a = 0.75; EndIf
SetFactory("Built-in");
c = (a * a - 1) / (2 * a);
Point(1) = {0, -1, 0, h};
Point(2) = {1, 0, 0, h};
Point(3) = {0, 1, 0, h};
Point(4) = {a, 0, 0, h};
Point(5) = {0, 0, 0};
Point(6) = {c, 0, 0};
Circle(1) = {1, 5, 2};
Circle(2) = {2, 5, 3};
Circle(3) = {3, 6, 4};
Circle(4) = {4, 6, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
If (Exists(quads))
  Recombine Surface{1};
EndIf
Mesh.HighOrderOptimize = 0;
