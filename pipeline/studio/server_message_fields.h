// The fields of the texts of the server, in the order in which they are written.
#pragma once

#include "core/fields.h"
#include "pipeline/studio/server_messages.h"

namespace carom::studio {

constexpr auto fields_of(Describes<Welcome>) {
    return fields<Welcome>(field("protocol", &Welcome::protocol),
                           field("version", &Welcome::version), field("v", &Welcome::v),
                           field("shot", &Welcome::shot), field("root", &Welcome::root),
                           field("output", &Welcome::output));
}

constexpr auto fields_of(Describes<StartFile>) {
    return fields<StartFile>(field("file", &StartFile::file), field("name", &StartFile::name),
                             field("about", &StartFile::about), field("still", &StartFile::still));
}

constexpr auto fields_of(Describes<Start>) {
    return fields<Start>(field("templates", &Start::templates), field("examples", &Start::examples),
                         field("recent", &Start::recent));
}

constexpr auto fields_of(Describes<Exists>) {
    return fields<Exists>(field("what", &Exists::what), field("file", &Exists::file),
                          field("name", &Exists::name));
}

constexpr auto fields_of(Describes<FolderEntry>) {
    return fields<FolderEntry>(field("name", &FolderEntry::name), field("file", &FolderEntry::file),
                               field("is_folder", &FolderEntry::is_folder));
}

constexpr auto fields_of(Describes<Folder>) {
    return fields<Folder>(field("folder", &Folder::folder), field("name", &Folder::name),
                          field("parent", &Folder::parent), field("entries", &Folder::entries));
}

constexpr auto fields_of(Describes<Imported>) {
    return fields<Imported>(field("name", &Imported::name), field("yaml", &Imported::yaml),
                            field("problems", &Imported::problems),
                            field("notes", &Imported::notes));
}

constexpr auto fields_of(Describes<Part>) {
    return fields<Part>(field("section", &Part::section), field("name", &Part::name),
                        field("about", &Part::about), field("exists", &Part::exists));
}

constexpr auto fields_of(Describes<Parts>) {
    return fields<Parts>(field("file", &Parts::file), field("parts", &Parts::parts));
}

constexpr auto fields_of(Describes<Addition>) {
    return fields<Addition>(field("section", &Addition::section), field("name", &Addition::name),
                            field("yaml", &Addition::yaml), field("of", &Addition::of));
}

constexpr auto fields_of(Describes<Additions>) {
    return fields<Additions>(field("list", &Additions::list));
}

constexpr auto fields_of(Describes<OpenFile>) {
    return fields<OpenFile>(field("file", &OpenFile::file), field("name", &OpenFile::name),
                            field("text", &OpenFile::text), field("hash", &OpenFile::hash),
                            field("writable", &OpenFile::writable),
                            field("changed", &OpenFile::changed));
}

constexpr auto fields_of(Describes<Files>) {
    return fields<Files>(field("v", &Files::v), field("files", &Files::files));
}

constexpr auto fields_of(Describes<TextChanged>) {
    return fields<TextChanged>(field("v", &TextChanged::v), field("file", &TextChanged::file),
                               field("text", &TextChanged::text),
                               field("base", &TextChanged::base));
}

constexpr auto fields_of(Describes<Saved>) {
    return fields<Saved>(field("file", &Saved::file), field("hash", &Saved::hash));
}

constexpr auto fields_of(Describes<DiskChanged>) {
    return fields<DiskChanged>(field("file", &DiskChanged::file), field("text", &DiskChanged::text),
                               field("hash", &DiskChanged::hash), field("gone", &DiskChanged::gone),
                               field("refused", &DiskChanged::refused));
}

constexpr auto fields_of(Describes<RecoveredText>) {
    return fields<RecoveredText>(
        field("file", &RecoveredText::file), field("text", &RecoveredText::text),
        field("base_hash", &RecoveredText::base_hash), field("hash", &RecoveredText::hash));
}

constexpr auto fields_of(Describes<Recovered>) {
    return fields<Recovered>(field("files", &Recovered::files));
}

constexpr auto fields_of(Describes<Failed>) {
    return fields<Failed>(field("what", &Failed::what), field("v", &Failed::v),
                          field("message", &Failed::message));
}

constexpr auto fields_of(Describes<FilmState>) {
    return fields<FilmState>(
        field("state", &FilmState::state), field("shot", &FilmState::shot),
        field("output", &FilmState::output), field("width", &FilmState::width),
        field("height", &FilmState::height), field("fps", &FilmState::fps),
        field("stage", &FilmState::stage), field("fraction", &FilmState::fraction),
        field("frames", &FilmState::frames), field("finished", &FilmState::finished),
        field("reused", &FilmState::reused), field("seconds", &FilmState::seconds),
        field("left", &FilmState::left), field("message", &FilmState::message),
        field("warnings", &FilmState::warnings), field("address", &FilmState::address));
}

constexpr auto fields_of(Describes<FilmFrame>) {
    return fields<FilmFrame>(field("frame", &FilmFrame::frame), field("reused", &FilmFrame::reused),
                             field("seconds", &FilmFrame::seconds),
                             field("address", &FilmFrame::address));
}

constexpr auto fields_of(Describes<Making>) {
    return fields<Making>(field("q", &Making::q), field("stage", &Making::stage),
                          field("fraction", &Making::fraction));
}

constexpr auto fields_of(Describes<Made>) {
    return fields<Made>(field("q", &Made::q), field("v", &Made::v), field("what", &Made::what),
                        field("address", &Made::address), field("file", &Made::file));
}

constexpr auto fields_of(Describes<Work>) {
    return fields<Work>(field("what", &Work::what), field("v", &Work::v),
                        field("fraction", &Work::fraction));
}

}  // namespace carom::studio
