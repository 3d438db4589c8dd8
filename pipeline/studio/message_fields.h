// The fields of all messages. The page's types (studio/src/protocol.ts) are generated from these
// lists.
#pragma once

#include "pipeline/studio/binary_message_fields.h"
#include "pipeline/studio/message_value_fields.h"
#include "pipeline/studio/page_message_fields.h"
#include "pipeline/studio/sequence_message_fields.h"
#include "pipeline/studio/server_message_fields.h"
#include "pipeline/studio/shot_message_fields.h"
#include "pipeline/studio/solve_message_fields.h"
#include "pipeline/studio/sound_message_fields.h"
