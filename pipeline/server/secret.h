// Random secrets and their comparison.
#pragma once

#include <string>
#include <string_view>

namespace carom::server {

/// 128 random bits from the operating system (getrandom) as 32 hexadecimal digits. Throws Error.
[[nodiscard]] std::string make_secret();

/// Compares in a time that does not depend on where the texts differ, only on their lengths.
[[nodiscard]] bool is_secret(std::string_view given, std::string_view secret);

}  // namespace carom::server
