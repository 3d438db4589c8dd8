#include "core/assert.h"

#include <cstdio>
#include <cstdlib>
#include <string>

#include <fmt/format.h>

namespace carom::detail {

namespace {

std::string text_of(const Operand& operand) {
    switch (operand.kind) {
        case Operand::Kind::boolean:
            return operand.bits != 0 ? "true" : "false";
        case Operand::Kind::signed_integer:
            return fmt::format("{}", static_cast<long long>(operand.bits));
        case Operand::Kind::unsigned_integer:
            return fmt::format("{}", operand.bits);
        case Operand::Kind::real:
            return fmt::format("{:.{}g}", operand.number, operand.digits);
        case Operand::Kind::pointer:
            return operand.address != nullptr ? fmt::format("{}", operand.address) : "null";
        case Operand::Kind::text:
            return fmt::format("\"{}\"", std::string_view(static_cast<const char*>(operand.address),
                                                          operand.bits));
        case Operand::Kind::unprintable:
            break;
    }
    return "?";
}

[[noreturn]] void stop(const char* condition, const char* file, int line,
                       const std::string& values) {
    std::fputs(
        fmt::format("{}:{}: assertion failed: {}{}\n", file, line, condition, values).c_str(),
        stderr);
    std::abort();
}

}  // namespace

void assertion_failed(const char* condition, const char* file, int line, const Comparison& values) {
    const bool has_values =
        values.sign != nullptr && (values.left.kind != Operand::Kind::unprintable ||
                                   values.right.kind != Operand::Kind::unprintable);
    stop(condition, file, line,
         has_values
             ? fmt::format(" ({} {} {})", text_of(values.left), values.sign, text_of(values.right))
             : "");
}

void assertion_failed(const char* condition, const char* file, int line, bool /*values*/) {
    stop(condition, file, line, "");
}

}  // namespace carom::detail
