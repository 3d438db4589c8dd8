// The texts that the server sends, except for what they say of the shot (shot_messages.h).
// messages.h says how they are sent.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace carom::studio {

/// The answer to Hello.
struct Welcome {
    static constexpr const char* kName = "welcome";
    std::string protocol{};
    std::string version{};  // of carom
    std::int64_t v = 0;     // the version of the texts
    std::string shot{};     // the path of the shot's file; empty: the start page
    std::string root{};     // the folder below which files may be written
    std::string output{};   // the folder of films and exports; empty: that of the shot
};

/// A file to start from.
struct StartFile {
    std::string file{};
    std::string name{};   // "nine_ball_break"
    std::string about{};  // its first comment
    std::string still{};  // the address of a picture, or empty
};

/// What the start page offers. Sent after Hello if no shot is open, and whenever it changes.
struct Start {
    static constexpr const char* kName = "start";
    std::vector<StartFile> templates{};
    std::vector<StartFile> examples{};
    std::vector<StartFile> recent{};
};

/// A file was not written because it exists. The page may ask for the same with `overwrite`.
struct Exists {
    static constexpr const char* kName = "exists";
    std::string what{};  // the kName of the request
    std::string file{};
    std::string name{};  // relative to the root
};

struct FolderEntry {
    std::string name{};
    std::string file{};      // absolute path
    bool is_folder = false;  // else a shot
};

/// The folders and the YAML files of a folder, sorted by their names.
struct Folder {
    static constexpr const char* kName = "folder";
    std::string folder{};  // absolute path
    std::string name{};    // relative to the root; empty: the root
    std::string parent{};  // absolute path; empty: this is the root
    std::vector<FolderEntry> entries{};
};

/// The answer to Import.
struct Imported {
    static constexpr const char* kName = "imported";
    std::string name{};
    std::string yaml{};                   // empty: it has errors
    std::vector<std::string> problems{};  // sentences with their places
    std::vector<std::string> notes{};     // what was assumed
};

/// A part that can be added.
struct Part {
    std::string section{};
    std::string name{};
    std::string about{};  // "sphere, felt"
    bool exists = false;  // the open shot has a part of that section and name
};

/// The answer to ReadParts.
struct Parts {
    static constexpr const char* kName = "parts";
    std::string file{};
    std::vector<Part> parts{};
};

/// What to add to the text of the open shot.
struct Addition {
    std::string section{};
    std::string name{};  // that the open shot does not have yet
    std::string yaml{};  // on one line; the value of the entry, or an item of the list
    std::string of{};    // the name of the part from which it was made
};

/// The answer to AddParts: the parts, the materials that they need, and everything renamed where
/// the open shot has that name.
struct Additions {
    static constexpr const char* kName = "additions";
    std::vector<Addition> list{};
};

struct OpenFile {
    std::string file{};     // absolute path
    std::string name{};     // as the shot names it, for a tab: "nine_ball_break.yaml"
    std::string text{};     // as it stands now: the page's text if it has one, else the disk's
    std::string hash{};     // of the file on disk
    bool writable = false;  // a file of carom's configs or outside of the root is not
    bool changed = false;   // `text` differs from the file on disk
};

/// The shot's file, first, and all files that it includes. Sent after Hello, and when the list
/// changes.
struct Files {
    static constexpr const char* kName = "files";
    std::int64_t v = 0;
    std::vector<OpenFile> files{};
};

/// Another page changed a text.
struct TextChanged {
    static constexpr const char* kName = "text_changed";
    std::int64_t v = 0;
    std::string file{};
    std::string text{};
    std::int64_t base = 0;  // the newest version that it has taken over
};

struct Saved {
    static constexpr const char* kName = "saved";
    std::string file{};
    std::string hash{};
};

/// A file on disk is no longer what it was when it was last read or saved. Also the answer to a
/// Save that is refused for this reason.
struct DiskChanged {
    static constexpr const char* kName = "disk_changed";
    std::string file{};
    std::string text{};    // the new one on disk
    std::string hash{};    // empty: there is none that can be read
    std::string gone{};    // what became of it then: "was deleted", "is a folder"
    bool refused = false;  // a Save
};

/// A text that was not saved before the studio ended unexpectedly.
struct RecoveredText {
    std::string file{};
    std::string text{};
    std::string base_hash{};  // of the file on disk from which it was made
    std::string hash{};       // of the file on disk now; empty: it does not exist
};

/// Texts of the shot's files that were not saved when the studio ended unexpectedly. Sent after
/// Files; nothing changes until the page answers with Recover.
struct Recovered {
    static constexpr const char* kName = "recovered";
    std::vector<RecoveredText> files{};
};

/// Something that was asked for failed; a sentence for the user.
struct Failed {
    static constexpr const char* kName = "failed";
    std::string what{};  // the kName of the request, or "bake", "picture"
    std::int64_t v = 0;
    std::string message{};
};

/// A film that is being made, or the last one. Sent when it starts, with each frame, and at its
/// end.
struct FilmState {
    static constexpr const char* kName = "film_state";
    std::string state{};   // "running", "stopping", "done", "stopped", "failed"
    std::string shot{};    // the file of its shot
    std::string output{};  // its path
    int width = 0;
    int height = 0;
    double fps = 0;
    std::string stage{};                  // "bake", "render", "encode"; empty before the first one
    double fraction = 0;                  // of the stage
    std::int64_t frames = 0;              // of the film
    std::int64_t finished = 0;            // of them
    std::int64_t reused = 0;              // of those, from the cache
    double seconds = 0;                   // since it started
    double left = -1;                     // estimate, s; negative: not known
    std::string message{};                // why it failed
    std::vector<std::string> warnings{};  // sentences
    std::string address{};  // GET it here once it is done; empty for an image sequence
};

/// A frame of the film that is being made, or of the last one, is finished. In no particular order.
struct FilmFrame {
    static constexpr const char* kName = "film_frame";
    std::int64_t frame = 0;
    bool reused = false;  // from the cache
    double seconds = 0;
    std::string address{};  // GET a small picture of it here, or empty
};

/// How far the answer to Make is.
struct Making {
    static constexpr const char* kName = "making";
    std::int64_t q = 0;
    std::string stage{};  // "bake", "render"
    double fraction = 0;  // of the stage
};

/// The answer to Make.
struct Made {
    static constexpr const char* kName = "made";
    std::int64_t q = 0;
    std::int64_t v = 0;  // of the texts that it shows; 0: of the files on disk
    std::string what{};
    std::string address{};  // GET it here
    std::string file{};     // that was written, or empty
};

/// What the server works on, for the status line.
struct Work {
    static constexpr const char* kName = "work";
    std::string what{};  // "bake", "solve", or empty: nothing
    std::int64_t v = 0;
    double fraction = 0;  // [0, 1]
};

}  // namespace carom::studio
