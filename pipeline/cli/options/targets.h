// Where the table of options writes what was given.
#pragma once

#include <string>

#include "pipeline/cli/commands.h"

namespace carom::cli {

/// Everything that the options write to.
struct Targets {
    TalkOptions talk;
    std::string log = "text";
    RenderCommand render;
    RetimeCommand retime;
    BakeCommand bake;
    FrameCommand frame;
    ContactSheetCommand sheet;
    InfoCommand info;
    CheckCommand check;
    ExportCommand export_;
    ReportCommand report;
    ImportCommand import_;
    ImportTrackCommand import_track;
    CompletionCommand completion;
    ManualCommand manual;
    MuxCommand mux;
    CacheCommand cache;
    PlanCommand plan;
    NewCommand new_;
    SchemaCommand schema;
    CompareCommand compare;
};

}  // namespace carom::cli
