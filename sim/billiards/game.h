// The games whose rules put balls back onto the table.
#pragma once

namespace carom::sim::billiards {

enum class Game { snooker, eight_ball, nine_ball, carom };

}  // namespace carom::sim::billiards
