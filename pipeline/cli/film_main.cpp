// The program libexec/carom/carom-film, which runs the commands that render. bin/carom executes it
// with its own arguments.
#include "pipeline/check/table_light.h"
#include "pipeline/check/text_check.h"
#include "pipeline/cli/command_line.h"
#include "pipeline/cli/encoded_sound.h"
#include "pipeline/cli/helper_program.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/video/music_source.h"
#include "pipeline/video/view_transform.h"

#ifdef __GLIBC__  // which the headers above define
#include <malloc.h>
#endif

namespace {

/// A film's frames need the same memory one after the other: asking the kernel for it each time
/// takes three percent of a quick frame. Larger blocks than those of usual frames are given back:
/// a large picture that is freed would leave holes that the next one does not fit in.
void keep_memory() {
#ifdef __GLIBC__
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    mallopt(M_MMAP_THRESHOLD, 1 << 27);
#endif
}

}  // namespace

int main(int argument_count, char** arguments) {
    using namespace carom::cli;
    keep_memory();
    const auto parsed = parse_command_line({arguments + 1, arguments + argument_count});
    if (const auto* early_exit = std::get_if<EarlyExit>(&parsed)) {
        return print(*early_exit);
    }
    return run_command(
        std::get<CommandLine>(parsed), [&](const Command& command, CommandContext& context) {
            try {
                if (const auto* cache = std::get_if<CacheCommand>(&command)) {
                    return run_for_shot(*cache, context);
                }
                context.music = carom::pipeline::music_of;
                context.text_problems = carom::pipeline::text_problems;
                context.view = carom::pipeline::try_view;
                context.table_light = [](const carom::pipeline::Shot& shot) {
                    return text_of(carom::pipeline::light_on_table(shot));
                };
                if (const auto* check = std::get_if<CheckCommand>(&command)) {
                    return run(*check, context);
                }
                if (const auto* exported = std::get_if<ExportCommand>(&command)) {
                    return run(*exported, context);
                }
                if (const auto* sound = std::get_if<SoundCommand>(&command)) {
                    return needs_encoder(*sound) ? write_encoded_sound(*sound, context)
                                                 : run(*sound, context);
                }
                run_here<Program::film>(command, context);
            } catch (const NeedsProgram& needed) {
                exec_program(needed.name(), arguments);
            }
        });
}
