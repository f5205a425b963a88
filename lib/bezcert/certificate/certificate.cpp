#include "bezcert/certificate/certificate.hpp"

#include "bezcert/certificate/meet_evidence.hpp"
#include "bezcert/certificate/mesh_evidence.hpp"
#include "bezcert/certificate/pair_evidence.hpp"
#include "bezcert/certificate/sign_evidence.hpp"
#include "bezcert/certificate/zero_evidence.hpp"

#include <ostream>
#include <stdexcept>

namespace bezcert {
namespace {

using Evidence = std::optional<std::string>;

// Beside SIGN.
Evidence injective_evidence(const Forms& forms, const Decision& decision) {
  switch (decision.injectivity_proof) {
    case InjectivityProof::midpoint: return "midpoint";
    case InjectivityProof::orientation: return "orientation";
    case InjectivityProof::boundary: return boundary_evidence(forms);
    default: return std::nullopt;  // the hull has a claim of its own
  }
}

// "u v", without what the barycentric coordinates have too much.
std::string uv_text(const Parameter& parameter) {
  const std::vector<Rational> uv = parameter.affine();
  return to_string(uv[0]) + ' ' + to_string(uv[1]);
}

// The hull condition shows det J > 0 as well.
ElementClaim hull_claim() { return {"injective hull", ElementState::injective, true}; }

// det J <= 0 somewhere, if nothing more can be shown.
ElementClaim invalid_claim(const Forms& forms, const Decision& decision) {
  if (decision.witness) {
    return {"invalid at " + uv_text(decision.witness->parameter), ElementState::invalid, false};
  }
  if (const Evidence zero = zero_evidence(forms, decision)) {
    return {"invalid " + *zero, ElementState::invalid, false};
  }
  return {};
}

ElementClaim regular_claim(const Forms& forms, const Decision& decision) {
  if (decision.injectivity_proof == InjectivityProof::jacobian_hull) return hull_claim();
  const Evidence positive = sign_evidence(forms, decision, WantedSign::positive);
  if (!positive) return {};
  const bool is_regular = decision.verdict == ElementVerdict::regular;
  ElementClaim claim{"regular " + *positive, ElementState::open, is_regular};
  if (decision.verdict == ElementVerdict::injective) {
    if (const Evidence proof = injective_evidence(forms, decision)) {
      return {"injective " + *positive + ' ' + *proof, ElementState::injective, true};
    }
  } else if (decision.verdict == ElementVerdict::overlapping) {
    if (const Evidence meet = meet_evidence(forms, *decision.overlap)) {
      return {"overlapping " + *positive + ' ' + *meet, ElementState::invalid, true};
    }
  }
  return claim;
}

ElementClaim folded_claim(const Forms& forms, const Decision& decision) {
  // The budget may have ended before a second sign was seen, but not for a folded element.
  const std::string negative = "folded " + uv_text(decision.witness->parameter);
  if (decision.other_witness) {
    return {negative + " at " + uv_text(decision.other_witness->parameter), ElementState::invalid, true};
  }
  if (const Evidence zero = zero_evidence(forms, decision)) {
    return {negative + ' ' + *zero, ElementState::invalid, true};
  }
  return invalid_claim(forms, decision);
}

ElementClaim claim_of(const Element& element, const Decision& decision) {
  const Forms forms(element);
  switch (decision.verdict) {
    case ElementVerdict::injective:
    case ElementVerdict::regular:
    case ElementVerdict::overlapping: return regular_claim(forms, decision);
    case ElementVerdict::degenerate: {
      const Evidence sign = sign_evidence(forms, decision, WantedSign::nonnegative);
      const Evidence zero = sign ? zero_evidence(forms, decision) : std::nullopt;
      if (!zero) return invalid_claim(forms, decision);
      return {"degenerate " + *sign + ' ' + *zero, ElementState::invalid, true};
    }
    case ElementVerdict::folded: return folded_claim(forms, decision);
    case ElementVerdict::reversed: {
      const Evidence sign = sign_evidence(forms, decision, WantedSign::negative);
      if (!sign) return invalid_claim(forms, decision);
      return {"reversed " + *sign, ElementState::invalid, true};
    }
    case ElementVerdict::undecided: {
      ElementClaim claim = invalid_claim(forms, decision);
      claim.full = true;
      return claim;
    }
  }
  throw std::logic_error("certificate: unknown verdict");
}

}  // namespace

ElementClaim claim_of(const Mesh& mesh, std::size_t i, const Decision& decision) {
  // The ordinary cases need no element.
  if (decision.verdict == ElementVerdict::injective) {
    if (decision.injectivity_proof == InjectivityProof::jacobian_hull) return hull_claim();
    if (decision.injectivity_proof == InjectivityProof::midpoint &&
        decision.sign_proof == SignProof::coefficients) {
      return {"injective coefficients midpoint", ElementState::injective, true};
    }
  }
  return claim_of(mesh.element(i), decision);
}

class CertificateWriter::BlockOfClaims : public Block {
 public:
  explicit BlockOfClaims(CertificateWriter& writer) : writer_(writer) {}

  void element(std::size_t i, const CheckedElement& checked) override {
    claims_.push_back(claim_of(*writer_.mesh_, i, checked.decision));
  }
  void finish() override {
    for (const ElementClaim& claim : claims_) {
      writer_.claims_.push_back(claim.state);
      if (!claim.full) ++writer_.without_evidence_;
      writer_.stream_ << std::to_string(writer_.claims_.size()) << ' ' << claim.text << '\n';
    }
    claims_.clear();
  }

 private:
  CertificateWriter& writer_;
  std::vector<ElementClaim> claims_;
};

void CertificateWriter::begin(const Mesh& mesh) {
  mesh_ = &mesh;
  claims_.clear();
  claims_.reserve(mesh.elements().size());
  without_evidence_ = 0;
  stream_ << "bezcert-certificate 1\nelements " << header_.elements_sha256 << "\nbasis " << header_.basis
          << "\nnumbers " << name(header_.numbers) << "\ncount " << std::to_string(mesh.elements().size())
          << '\n';
}

std::unique_ptr<CheckObserver::Block> CertificateWriter::new_block() {
  return std::make_unique<BlockOfClaims>(*this);
}

void CertificateWriter::end(const Mesh&, const MeshReport& report) {
  if (!write_mesh_evidence(stream_, report.mesh, claims_)) ++without_evidence_;
  stream_ << "end\n";
}

}  // namespace bezcert
