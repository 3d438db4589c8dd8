#include "pipeline/cli/farm/farm_actions.h"

namespace carom::cli {

void run(const FarmCommand& command, CommandContext& context) {
    switch (command.action) {
        case FarmCommand::Action::submit:
            return farm_submit(command, context);
        case FarmCommand::Action::export_job:
            return farm_export(command, context);
        case FarmCommand::Action::status:
            return farm_status(command, context);
        case FarmCommand::Action::cancel:
            return farm_cancel(command, context);
        case FarmCommand::Action::change:
            return farm_change(command, context);
        case FarmCommand::Action::logs:
            return farm_logs(command, context);
        case FarmCommand::Action::resume:
            return farm_resume(command, context);
        case FarmCommand::Action::list:
            return farm_list(command, context);
        case FarmCommand::Action::frames:
            return farm_frames(command, context);
        case FarmCommand::Action::retry:
            return farm_retry(command, context);
        case FarmCommand::Action::skip:
            return farm_skip(command, context);
        case FarmCommand::Action::prefer:
            return farm_prefer(command, context);
        case FarmCommand::Action::watch:  // of another program
            throw InputError("this program does not have this command; run carom instead");
        case FarmCommand::Action::work:
            return farm_work(command, context);
        case FarmCommand::Action::finish:
            return farm_finish(command, context);
    }
}

}  // namespace carom::cli
