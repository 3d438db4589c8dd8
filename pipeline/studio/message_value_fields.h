// The fields of what messages have in common, in the order in which they are written.
#pragma once

#include "core/fields.h"
#include "pipeline/studio/message_values.h"

namespace carom::studio {

constexpr auto fields_of(Describes<TextRange>) {
    return fields<TextRange>(field("file", &TextRange::file), field("line", &TextRange::line),
                             field("column", &TextRange::column),
                             field("length", &TextRange::length));
}

}  // namespace carom::studio
