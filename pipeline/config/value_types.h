// Includes all types of values.
#pragma once

#include "pipeline/config/colour_type.h"
#include "pipeline/config/combined_types.h"
#include "pipeline/config/list_types.h"
#include "pipeline/config/map_types.h"
#include "pipeline/config/number_types.h"
#include "pipeline/config/word_types.h"
