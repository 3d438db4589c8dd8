// Prints the page's types of the messages: write_protocol > studio/src/protocol.ts
#include <cstdio>
#include <string>

#include "pipeline/studio/protocol_types.h"

int main() {
    const std::string text = carom::studio::protocol_types();
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 1;
}
