// The state of a session: its shot, its pages, and those who work for it. Its functions are in
// session.cpp, what a page's messages do in session_messages.cpp, and the open shot in
// session_shot.cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "pipeline/studio/disk_watch.h"
#include "pipeline/studio/documents.h"
#include "pipeline/studio/errands.h"
#include "pipeline/studio/file_desk.h"
#include "pipeline/studio/film_run.h"
#include "pipeline/studio/live_shot.h"
#include "pipeline/studio/live_sound.h"
#include "pipeline/studio/newest_messages.h"
#include "pipeline/studio/opened_shot.h"
#include "pipeline/studio/outcome_fan.h"
#include "pipeline/studio/picture_view.h"
#include "pipeline/studio/scene_annotations.h"
#include "pipeline/studio/scene_meshes.h"
#include "pipeline/studio/sequence_pictures.h"
#include "pipeline/studio/session.h"
#include "pipeline/studio/shot_solver.h"

namespace carom::studio {

/// The public functions are those of Session.
class Session::State {
  public:
    State(SessionOptions options, Send send);
    ~State();
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    State(State&&) = delete;
    State& operator=(State&&) = delete;

    void opened(PageId page);
    void closed(PageId page);
    void received(PageId page, const std::string& text);
    [[nodiscard]] std::optional<Download> find(std::string_view path);
    [[nodiscard]] std::string files_root();

  private:
    void start_workers();

    // What a message does; with the mutex. What they throw is answered with Failed.
    void receive(PageId page, const Hello& hello);
    void receive(PageId page, const TextChange& change);
    void receive(PageId page, const Save& request);
    void receive(PageId page, const Revert& request);
    void receive(PageId page, const Open& request);
    void receive(PageId page, const SaveAs& request);
    void receive(PageId page, const Offer& message);
    void receive(PageId page, const Forget& request);
    void receive(PageId page, const ListFolder& request);
    void receive(PageId page, const Import& request);
    void receive(PageId page, const ReadParts& request);
    void receive(PageId page, const AddParts& request);
    void receive(PageId page, const Fan& question);
    void receive(PageId page, const Unfan& message);
    void receive(PageId page, const SolveShot& question);
    void receive(PageId page, const Judge& question);
    void receive(PageId page, const Unsolve& message);
    void receive(PageId page, const Dragging& dragging);
    void receive(PageId page, const Recover& answer);
    void receive(PageId page, const Simulate& message);
    void receive(PageId page, const See& question);
    void receive(PageId page, const Unsee& message);
    void receive(PageId page, const SeeAnnotations& question);
    void receive(PageId page, const StartFilm& request);
    void receive(PageId page, const StopFilm& message);
    void receive(PageId page, const Make& request);
    void receive(PageId page, const StopMaking& request);

    // For those; with the mutex.
    void send_welcome(PageId page);
    void send_files(PageId page);
    void set_dragging(PageId page, bool on);
    bool open_or_ask(PageId page, const std::variant<std::string, Exists>& file);
    [[nodiscard]] OpenedShot& require_shot();
    [[nodiscard]] const std::string& root() const;
    [[nodiscard]] std::int64_t version() const;
    [[nodiscard]] OpenShot open_texts() const;

    // The open shot; with the mutex.
    [[nodiscard]] std::string answers_folder() const;
    [[nodiscard]] std::string root_for(const std::string& path) const;
    void open_shot(const std::string& path);
    int close_shot();
    void offer();
    void show(const std::shared_ptr<const pipeline::Shot>& shot,
              const std::shared_ptr<const sim::Timeline>& timeline, std::int64_t v);

    // What others say, from their threads; without the mutex.
    [[nodiscard]] LiveOutput output_of(int opening);
    void show_meshes(int opening, std::int64_t v, const pipeline::Shot& shot);
    void make_meshes(int opening, std::int64_t v, const std::string& hash,
                     const pipeline::Shot& shot);
    void take_text(int opening, const ServerMessage& message);
    void take_files(int opening, const std::vector<pipeline::ReadFile>& files,
                    const std::vector<std::string>& missing);
    void take_answer(int opening, const LiveAnswer& answer);
    void take_sequence(int opening, SequenceAnswer answer);
    void draw_card(PageId page, const pipeline::TitleCard& card, const PictureHead& head);
    void send_picture(PageId page, const Picture& picture);
    [[nodiscard]] bool look_at_disk();

    SessionOptions options_;
    std::string root_;  // of shots that are below it
    MeshFiles meshes_;
    NewestMessages messages_;  // its mutex is taken after the one below
    std::mutex wanted_meshes_mutex_;
    std::string wanted_meshes_;  // the hash of those of the newest version
    Errands mesh_work_;          // large meshes take seconds, for which no answer waits

    std::mutex mutex_;                  // of the members up to opening_
    std::shared_ptr<OpenedShot> shot_;  // null: the start page
    std::set<PageId> pages_;
    std::set<PageId> dragging_;
    int opening_ = 0;  // counts the shots that were opened and closed; messages_ has it, too

    // They send messages from threads of their own.
    std::unique_ptr<FileDesk> desk_;
    std::unique_ptr<OutcomeFan> fan_;
    std::unique_ptr<ShotSolver> solver_;
    std::unique_ptr<SceneAnnotations> annotations_;
    std::unique_ptr<PictureView> pictures_;
    std::unique_ptr<SequencePictures> films_;  // with the mutex
    std::unique_ptr<Documents> documents_;
    std::unique_ptr<LiveSound> sound_;
    std::unique_ptr<FilmRun> film_;    // it also calls the pictures
    std::unique_ptr<LiveShot> ended_;  // of the shot before
    std::unique_ptr<LiveShot> live_;   // ends before what it calls
    std::unique_ptr<DiskWatch> watch_;
};

}  // namespace carom::studio
