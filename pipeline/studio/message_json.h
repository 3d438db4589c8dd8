// Messages as JSON texts and as binary messages.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "pipeline/studio/message_lists.h"

namespace carom::studio {

/// One JSON object: the member "t", then the fields. A number that is not finite becomes null.
[[nodiscard]] std::string to_json(const PageMessage& message);
[[nodiscard]] std::string to_json(const ServerMessage& message);

/// Reads a text of a page. All fields have to be given, and no others; optional ones may be null or
/// absent. Throws Error with a sentence that names the message and its member.
[[nodiscard]] PageMessage read_page_message(std::string_view text);

/// The same for a text of the server.
[[nodiscard]] ServerMessage read_server_message(std::string_view text);

/// A binary message of that head and payload (messages.h).
[[nodiscard]] std::string pack(const BinaryHead& head, std::span<const std::byte> payload);

/// A binary message in its parts. `payload` is a part of the bytes that were read.
struct Unpacked {
    BinaryHead head;
    std::span<const std::byte> payload;
};

/// Throws Error with a sentence that says what is wrong.
[[nodiscard]] Unpacked unpack(std::span<const std::byte> bytes);

/// The kName of a message, which is also the slot of those of which only the newest counts.
[[nodiscard]] std::string_view name_of(const ServerMessage& message);
[[nodiscard]] std::string_view name_of(const BinaryHead& head);

}  // namespace carom::studio
