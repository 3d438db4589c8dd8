#include "tests/pipeline/server/raw_client.h"

#include <array>
#include <cerrno>
#include <stdexcept>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace carom::testing {

std::string HttpAnswer::field(const std::string& name) const {
    const std::size_t at = head.find("\r\n" + name + ": ");
    if (at == std::string::npos) {
        return {};
    }
    const std::size_t begin = at + name.size() + 4;
    return head.substr(begin, head.find("\r\n", begin) - begin);
}

int Frame::close_code() const {
    return operation == 8 && payload.size() >= 2 ? static_cast<unsigned char>(payload[0]) * 256 +
                                                       static_cast<unsigned char>(payload[1])
                                                 : 0;
}

std::string frame_bytes(int operation, std::string_view payload, bool is_final, bool is_masked) {
    std::string bytes;
    bytes += static_cast<char>((is_final ? 0x80 : 0) | operation);
    const int mask_bit = is_masked ? 0x80 : 0;
    const int length_bytes = payload.size() < 126 ? 0 : payload.size() < 65536 ? 2 : 8;
    bytes += static_cast<char>(mask_bit | (length_bytes == 0   ? static_cast<int>(payload.size())
                                           : length_bytes == 2 ? 126
                                                               : 127));
    for (int i = length_bytes - 1; i >= 0; --i) {
        bytes += static_cast<char>(payload.size() >> (8 * i));
    }
    constexpr std::string_view kMask = "\x12\x34\x56\x78";
    if (is_masked) {
        bytes += kMask;
    }
    for (std::size_t i = 0; i < payload.size(); ++i) {
        bytes += static_cast<char>(is_masked ? payload[i] ^ kMask[i % 4] : payload[i]);
    }
    return bytes;
}

RawClient::RawClient(std::uint16_t port, int receive_buffer_bytes, const char* address)
    : descriptor_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    if (receive_buffer_bytes > 0) {
        ::setsockopt(descriptor_, SOL_SOCKET, SO_RCVBUF, &receive_buffer_bytes,
                     sizeof(receive_buffer_bytes));
    }
    const timeval longest{30, 0};
    ::setsockopt(descriptor_, SOL_SOCKET, SO_RCVTIMEO, &longest, sizeof(longest));
    ::setsockopt(descriptor_, SOL_SOCKET, SO_SNDTIMEO, &longest, sizeof(longest));
    sockaddr_in server{};
    server.sin_family = AF_INET;
    server.sin_port = htons(port);
    ::inet_pton(AF_INET, address, &server.sin_addr);
    if (::connect(descriptor_, reinterpret_cast<const sockaddr*>(&server), sizeof(server)) != 0) {
        ::close(descriptor_);
        throw std::runtime_error("the test cannot connect to the server");
    }
}

RawClient::~RawClient() {
    ::close(descriptor_);
}

void RawClient::send(std::string_view bytes) const {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent <= 0) {
            return;
        }
        bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
}

bool RawClient::receive() {
    std::array<char, 1 << 16> part{};
    const ssize_t size = ::recv(descriptor_, part.data(), part.size(), 0);
    if (size <= 0) {
        has_timed_out_ = size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK);
        return false;
    }
    received_.append(part.data(), static_cast<std::size_t>(size));
    return true;
}

bool RawClient::receive_at_least(std::size_t size) {
    while (received_.size() < size) {
        if (!receive()) {
            return false;
        }
    }
    return true;
}

std::string RawClient::take(std::size_t size) {
    std::string taken = received_.substr(0, size);
    received_.erase(0, size);
    return taken;
}

HttpAnswer RawClient::read_answer(bool has_body) {
    std::size_t end = std::string::npos;
    while ((end = received_.find("\r\n\r\n")) == std::string::npos) {
        if (!receive()) {
            return {};
        }
    }
    HttpAnswer answer;
    answer.head = take(end + 4);
    answer.status = std::stoi(answer.head.substr(answer.head.find(' ') + 1));
    const std::string length = answer.field("Content-Length");
    if (has_body && !length.empty()) {
        receive_at_least(std::stoull(length));
        answer.body = take(std::stoull(length));
    }
    return answer;
}

std::optional<Frame> RawClient::read_frame() {
    if (!receive_at_least(2)) {
        return std::nullopt;
    }
    const auto byte = [&](std::size_t i) {
        return static_cast<std::uint64_t>(static_cast<unsigned char>(received_[i]));
    };
    std::uint64_t length = byte(1);
    const std::size_t length_bytes = length == 126 ? 2 : length == 127 ? 8 : 0;
    if (!receive_at_least(2 + length_bytes)) {
        return std::nullopt;
    }
    if (length_bytes > 0) {
        length = 0;
        for (std::size_t i = 0; i < length_bytes; ++i) {
            length = length * 256 + byte(2 + i);
        }
    }
    const int operation = static_cast<int>(byte(0) & 15);
    if (!receive_at_least(2 + length_bytes + length)) {
        return std::nullopt;
    }
    static_cast<void>(take(2 + length_bytes));
    return Frame{operation, take(length)};
}

bool RawClient::is_closed_by_server() {
    while (receive()) {
        received_.clear();
    }
    return !has_timed_out_;
}

}  // namespace carom::testing
