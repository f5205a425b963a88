// The certificate of a mesh: one claim for every element and one for the mesh, each with evidence that
// `verifier` checks without any of this library (docs/certificate-format.md).
//
// Claims are those of the decision. Where evidence would exceed the format's limits a weaker claim is
// written, at the weakest `undecided`, and counted.
#pragma once

#include "bezcert/check/check_mesh.hpp"

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace bezcert {

/// What the certificate is about.
struct CertificateHeader {
  std::string elements_sha256;  ///< of the elements file's bytes, lower-case hexadecimal
  std::string basis;            ///< "lagrange", "bernstein" (.msh) or "mixed" (.bez.json)
  Numbers numbers = Numbers::binary64;
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

/// Writes the certificate of a mesh while it is checked (check/check_mesh.hpp).
class CertificateWriter : public CheckObserver {
 public:
  /// Keeps a reference to `stream`.
  CertificateWriter(std::ostream& stream, CertificateHeader header)
      : stream_(stream), header_(std::move(header)) {}

  void begin(const Mesh& mesh) override;
  std::unique_ptr<Block> new_block() override;
  void end(const Mesh& mesh, const MeshReport& report) override;

  /// Verdicts that the certificate does not claim in full.
  std::size_t without_evidence() const { return without_evidence_; }

 private:
  class BlockOfClaims;

  std::ostream& stream_;
  CertificateHeader header_;
  const Mesh* mesh_ = nullptr;
  std::vector<ElementState> claims_;  // what the certificate claims of each element
  std::size_t without_evidence_ = 0;
};

}  // namespace bezcert
