// The types of values that keys may have, as building blocks: all of them.
#pragma once

#include "pipeline/config/colour_type.h"
#include "pipeline/config/combined_types.h"
#include "pipeline/config/list_types.h"
#include "pipeline/config/map_types.h"
#include "pipeline/config/number_types.h"
#include "pipeline/config/word_types.h"
