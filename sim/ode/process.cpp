#include "sim/ode/process.h"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <mutex>
#include <utility>

#include <fmt/core.h>
#include <ode/ode.h>

#include "core/error.h"

namespace carom::sim::ode {
namespace {

thread_local ThreadGuard* current_guard = nullptr;
thread_local MessageCapture* current_capture = nullptr;

__attribute__((format(printf, 1, 0))) std::string formatted(const char* format,
                                                            std::va_list arguments) {
    std::array<char, 512> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    return text.data();
}

__attribute__((format(printf, 2, 0))) void on_message(int, const char* format,
                                                      std::va_list arguments) {
    if (current_capture != nullptr) {
        current_capture->add_message(formatted(format, arguments));
    } else if (current_guard != nullptr) {
        current_guard->add_message(formatted(format, arguments));
    }
}

// ODE ends the process when these handlers return, so they throw; the world being stepped is then
// discarded.
[[noreturn]] __attribute__((format(printf, 2, 0))) void on_error(int number, const char* format,
                                                                 std::va_list arguments) {
    throw Error(fmt::format("ODE failed ({}): {}", number, formatted(format, arguments)));
}

void start_once() {
    static std::once_flag started;
    std::call_once(started, [] {
        dSetMessageHandler(&on_message);
        dSetErrorHandler(&on_error);
        dSetDebugHandler(&on_error);
        if (dInitODE2(0) == 0) {
            throw Error("ODE could not be initialised (dInitODE2 failed)");
        }
    });
}

}  // namespace

ThreadGuard::ThreadGuard() : outer_(current_guard) {
    start_once();
    if (dAllocateODEDataForThread(dAllocateMaskAll) == 0) {
        throw Error("ODE could not allocate its data for this thread");
    }
    current_guard = this;
}

ThreadGuard::~ThreadGuard() {
    current_guard = outer_;
}

void ThreadGuard::add_message(std::string text) {
    if (std::find(messages_.begin(), messages_.end(), text) == messages_.end()) {
        messages_.push_back(std::move(text));
    }
}

MessageCapture::MessageCapture() : outer_(current_capture) {
    current_capture = this;
}

MessageCapture::~MessageCapture() {
    current_capture = outer_;
}

void MessageCapture::forward() {
    if (current_guard == nullptr) {
        return;
    }
    for (std::string& text : messages_) {
        current_guard->add_message(std::move(text));
    }
    messages_.clear();
}

}  // namespace carom::sim::ode
