// The messages between carom's studio and its page, as plain data.
//
// Texts are JSON objects whose member "t" is the message's kName and whose other members are the
// fields of the struct. A binary message is a 32-bit type, the 32-bit length of its head, the head
// (JSON like the texts, padded with spaces to a multiple of 8 bytes, which its length counts), and
// a payload of little-endian numbers that the head describes. Lengths are in metres, times in
// seconds, angles in radians; world axes have Z up. Numbers that count versions start at 1.
//
// The page's types are generated from message_fields.h: `studio/src/protocol.ts`.
#pragma once

#include "pipeline/studio/binary_messages.h"
#include "pipeline/studio/message_values.h"
#include "pipeline/studio/page_messages.h"
#include "pipeline/studio/sequence_messages.h"
#include "pipeline/studio/server_messages.h"
#include "pipeline/studio/shot_messages.h"
#include "pipeline/studio/solve_messages.h"
#include "pipeline/studio/sound_messages.h"
