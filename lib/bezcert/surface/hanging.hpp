// Hanging nodes that tear the elements around a vertex apart.
//
// A long edge from a to b faces two or more short ones between the same vertices. None of them is glued, so
// the elements at a and b fall into several fans, as if parts of the mesh only touched there. What is wrong
// is the node in between: it is named, as non_conforming, before vertices are looked at. (Hanging nodes at
// vertices with one fan are found where the boundary meets itself: boundary_contacts.hpp.)
#pragma once

#include "bezcert/surface/gluing.hpp"

namespace bezcert {

/// Looks at vertices where two or more boundary edges begin. The short edges begin at an end of the long one
/// and run exactly along it; or there are two of them, between its ends, close to it (element_frame.hpp).
/// Adds obstacles and marks the edges as faulty.
void find_hanging_nodes(const MeshEdges& edges, const CornersByVertex& corners, Gluing& gluing,
                        ObstacleList& obstacles);

}  // namespace bezcert
