// SHA-256 (FIPS 180-4).
#pragma once

#include <string>
#include <string_view>

namespace verifier {

/// In lower-case hex.
std::string sha256(std::string_view bytes);

}  // namespace verifier
