// Plate [0,3] x [0,2] with three round holes; two of them leave a narrow bridge.
If (!Exists(h)) h = 0.6; EndIf
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 3, 2};
Disk(2) = {0.8, 1, 0, 0.5};
Disk(3) = {1.95, 1, 0, 0.55};
Disk(4) = {2.7, 0.3, 0, 0.2};
BooleanDifference(5) = { Surface{1}; Delete; }{ Surface{2:4}; Delete; };
Mesh.MeshSizeMin = h;
Mesh.MeshSizeMax = h;
If (Exists(quads))
  Recombine Surface{:};
EndIf
Mesh.HighOrderOptimize = 0;
