#!/usr/bin/env bash
# Makes corpus/meshes/*.msh with gmsh 4.8.4 (Debian 12) from corpus/meshes/geo/*.geo. The meshes are committed: this
# script is their documentation, and gives the same bytes when run again. Usage: make_meshes.sh [OUTPUT_DIRECTORY]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
geo=$here/meshes/geo
out=${1:-$here/meshes}
mkdir -p "$out"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

[ "$(gmsh --version 2>&1)" = 4.8.4 ] || { echo "make_meshes.sh: gmsh 4.8.4 is needed" >&2; exit 1; }

# make OUTPUT GEO FORMAT ORDER [gmsh options]; FORMAT is 22a, 22b, 41a or 41b
make() {
  local output=$1 source=$2 format=$3 order=$4 binary=()
  shift 4
  [ "${format#??}" = b ] && binary=(-bin)
  # options are read before the .geo file, which sets HighOrderOptimize = 0 itself
  gmsh "$geo/$source.geo" -2 -order "$order" -format "msh${format%?}" "${binary[@]}" -v 0 -nt 1 \
    -setnumber Mesh.RandomSeed 1 "$@" -o "$output" < /dev/null
}

# again INPUT OUTPUT FORMAT: the same mesh in another format
again() {
  local binary=()
  [ "${3#??}" = b ] && binary=(-bin)
  gmsh "$1" -save -format "msh${3%?}" "${binary[@]}" -v 0 -setnumber Mesh.SaveAll 1 -o "$2" < /dev/null
}

all='-setnumber Mesh.SaveAll 1'
rewrite() { python3 "$geo/rewrite.py" "$@"; }

# one mesh in four formats: all from the 16 digits of the first, so that all four hold the same doubles
make "$out/crescent_p3_22a.msh" crescent 22a 3 -setnumber a 0.9 -setnumber h 0.4 $all
for format in 22b 41a 41b; do
  again "$out/crescent_p3_22a.msh" "$out/crescent_p3_$format.msh" $format
done
# the same with gmsh's own doubles, of which the 16 digits lose the last bits
make "$out/crescent_p3_full_41b.msh" crescent 41b 3 -setnumber a 0.9 -setnumber h 0.4 $all

# triangles of orders 2, 4, 5, 6, 10
make "$out/annulus_p2_41b.msh" annulus 41b 2
make "$out/plate_p2_41a.msh" plate 41a 2 -setnumber h 0.7
make "$out/plate_p4_22b.msh" plate 22b 4 -setnumber h 0.7
make "$out/aerofoil_p4_41a.msh" aerofoil 41a 4 -setnumber parts 2
make "$out/aerofoil_p5_41b.msh" aerofoil 41b 5 -setnumber parts 3
make "$out/aerofoil_p6_22a.msh" aerofoil 22a 6 -setnumber parts 2
make "$out/crescent_p10_41b.msh" crescent 41b 10 -setnumber a 0.85 -setnumber h 0.8

# quadrilaterals of orders 2, 3, 4, and files with both shapes
make "$out/annulus_q2_22a.msh" annulus 22a 2 -setnumber quads 1
make "$out/annulus_q3_41b.msh" annulus 41b 3 -setnumber quads 1 -setnumber r 0.9
make "$out/aerofoil_q3_22b.msh" aerofoil 22b 3 -setnumber quads 1 -setnumber parts 4
make "$out/aerofoil_q4_41a.msh" aerofoil 41a 4 -setnumber quads 1 -setnumber parts 2
make "$out/notch_q2_22b.msh" notch 22b 2 -setnumber parts 3
make "$out/notch_q3_22a.msh" notch 22a 3 -setnumber parts 3
make "$out/notch_q4_41b.msh" notch 41b 4 -setnumber parts 3
make "$out/notch_q5_41a.msh" notch 41a 5 -setnumber parts 3
make "$out/plate_mixed_p2_22b.msh" plate 22b 2 -setnumber quads 1 -setnumber h 0.6
make "$out/plate_mixed_p3_41a.msh" plate 41a 3 -setnumber quads 1 -setnumber h 0.6 $all
make "$out/crescent_mixed_p4_41b.msh" crescent 41b 4 -setnumber quads 1 -setnumber a 0.85 -setnumber h 0.6
make "$out/crescent_mixed_p3_22b.msh" crescent 22b 3 -setnumber quads 1 -setnumber a 0.9 -setnumber h 0.25

# clockwise elements: half the ring, the whole ring, and a mirrored file
make "$out/annulus_q3_turned_41a.msh" annulus 41a 3 -setnumber quads 1 -setnumber parts 2 -setnumber turned 3
make "$out/annulus_p4_turned_22b.msh" annulus 22b 4 -setnumber parts 2 -setnumber turned 1
rewrite mirror "$out/crescent_p3_22a.msh" "$out/crescent_p3_mirrored_22a.msh"

# unusual but legal files
make "$out/plate_p2_parametric_41a.msh" plate 41a 2 -setnumber h 0.7 -setnumber Mesh.SaveParametric 1 $all
make "$out/plate_p2_parametric_41b.msh" plate 41b 2 -setnumber h 0.7 -setnumber Mesh.SaveParametric 1 $all
make "$out/channel_p3_41b.msh" channel 41b 3
make "$out/channel_p3_41a.msh" channel 41a 3
make "$out/channel_p3_22a.msh" channel 22a 3 $all
gmsh "$geo/slab.geo" -3 -order 2 -format msh41 -v 0 -nt 1 -o "$out/slab_p2_41a.msh" < /dev/null
gmsh "$geo/slab.geo" -3 -order 2 -format msh22 -bin -v 0 -nt 1 -o "$out/slab_p2_22b.msh" < /dev/null
make "$out/plate_p2_partitioned_22a.msh" plate 22a 2 -setnumber h 0.7 -part 2
make "$out/plate_p2_partitioned_41b.msh" plate 41b 2 -setnumber h 0.7 -part 2
make "$work/plate.msh" plate 41a 3 -setnumber h 0.7 $all
rewrite sparse "$work/plate.msh" "$out/plate_p3_sparse_41a.msh"
rewrite no_entities "$out/crescent_p3_41a.msh" "$out/crescent_p3_no_entities_41a.msh"
rewrite no_tags "$out/crescent_p3_22a.msh" "$out/crescent_p3_no_tags_22a.msh"
rewrite extras "$out/crescent_p3_22a.msh" "$out/crescent_p3_extras_22a.msh"
rewrite crlf "$out/crescent_p3_22a.msh" "$out/crescent_p3_crlf_22a.msh"
for order in 1 2 3 4; do
  make "$work/order$order.msh" aerofoil 22a $order -setnumber parts 3
done
rewrite mixed "$work"/order[1234].msh "$out/aerofoil_p1234_22a.msh"
rewrite mixed_exact "$out/fan_p1234_22a.msh"
rewrite quarter_point "$out/quarter_point_22a.msh"
rewrite classes "$out/classes_22a.msh"
