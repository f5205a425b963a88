// The certificate of a mesh: one claim for every element and one for the mesh, each with evidence that
// `verifier` checks without any of this library (docs/certificate-format.md).
//
// Claims are those of the decision. Where evidence would exceed the format's limits a weaker claim is
// written, at the weakest `undecided`, and counted.
#pragma once

#include "bezcert/decide/decide.hpp"
#include "bezcert/surface/embedding.hpp"

#include <iosfwd>
#include <string>
#include <vector>

namespace bezcert {

/// What the certificate is about.
struct CertificateHeader {
  std::string elements_sha256;  ///< of the elements file's bytes, lower-case hexadecimal
  std::string basis;            ///< "lagrange", "bernstein" (.msh) or "mixed" (.bez.json)
  Numbers numbers = Numbers::binary64;
  std::size_t count = 0;  ///< elements
};

/// A claim about one element with its evidence.
struct ElementClaim {
  std::string text = "undecided";
  ElementState state = ElementState::open;  ///< what it says of the element
  bool full = false;                        ///< whether it says all that the decision does
};

/// The claim that a decision allows. Precondition: `decision` is decide's of the mesh's i-th element. Claims
/// of different elements can be made on different threads.
ElementClaim claim_of(const Mesh& mesh, std::size_t i, const Decision& decision);

/// Writes a certificate line by line: every element in mesh order, then the mesh.
class CertificateWriter {
 public:
  /// Writes the header. Keeps a reference to `stream`.
  CertificateWriter(std::ostream& stream, const CertificateHeader& header);

  /// The claim of the next element. Throws std::logic_error beyond the number that the header says.
  void element(const ElementClaim& claim);

  /// The claim of the mesh and the end. Preconditions: `result` is examine_mesh's; all elements were written.
  void mesh(const MeshResult& result);

  /// Verdicts that the certificate does not claim in full.
  std::size_t without_evidence() const { return without_evidence_; }

 private:
  std::ostream& stream_;
  std::size_t count_ = 0;
  std::vector<ElementState> claims_;  // what the certificate claims of each element
  std::size_t without_evidence_ = 0;
};

}  // namespace bezcert
