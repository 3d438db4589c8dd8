#include "pipeline/farm/farm_job.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "pipeline/farm/round.h"
#include "pipeline/farm/worker_file.h"
#include "tests/scratch_folder.h"

namespace carom::farm {
namespace {

using carom::testing::ScratchFolder;
using carom::testing::write_text;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string normal(const std::string& path) {
    return std::filesystem::path(path).lexically_normal().string();
}

FarmJob make_job(const std::string& folder) {
    FarmJob job;
    job.folder = normal(folder);
    job.film = "/films/a \"film\" 100 %.mp4";
    job.shot = "shots/break.yaml";
    job.name = "break";
    job.store = "/store";
    job.frames = "0-9x2";
    job.workers = 7;
    job.tasks_at_once = 3;
    job.processors = 2;
    job.memory = 500;
    job.budget = 12.5;
    job.dead_after = 3;
    job.partition = "short";
    job.priority = -5;
    job.time = 22;
    job.film_time = 15;
    job.engine_options = {"--qos=high", "--constraint=\"a\nb\""};
    job.exec_after = "cp \"$CAROM_FILM\" /films";
    job.film_mask = 027;
    job.is_sequence = true;
    job.id = "1f3a5b";
    return job;
}

TEST(FarmJob, File_IsReadAgainWithEveryField) {
    const ScratchFolder folder;
    const FarmJob job = make_job(folder.path());
    EXPECT_FALSE(is_job_folder(folder.path()));
    write_job(job);
    EXPECT_TRUE(is_job_folder(folder.path()));
    EXPECT_EQ(read_job(folder.path()), job);
}

TEST(FarmJob, Id_IsTheEndOfTheFoldersName) {
    const ScratchFolder folder;
    const std::string made = make_job_folder(folder.path(), "/films/break-3.mp4", Readers::none);
    EXPECT_TRUE(made.ends_with("/break-3-" + job_id(made))) << made;
    EXPECT_TRUE(job_id(made).ends_with("-1"));
    EXPECT_EQ(job_id("/store/farm/zzz-1"), "zzz-1");
    EXPECT_EQ(job_id("/store/farm/a-12345g-1"), "a-12345g-1");
    EXPECT_EQ(job_id("/store/farm/a-123456-1x"), "a-123456-1x");
    EXPECT_EQ(job_id("/store/farm/-123456-1"), "-123456-1");
}

TEST(FarmJob, PortableJob_IsWhereItsFolderIs) {
    const ScratchFolder folder;
    FarmJob job = make_job(folder.path());
    job.film = "film.mp4";
    job.store = "store";
    job.is_portable = true;
    write_job(job);
    const FarmJob read = read_job(folder.path());
    EXPECT_EQ(read.film, normal(folder.path("film.mp4")));
    EXPECT_EQ(read.store, normal(folder.path("store")));
}

TEST(FarmJob, OtherFolders_AreErrorsThatSayWhy) {
    const ScratchFolder folder;
    const auto problem = [&] {
        try {
            (void)read_job(folder.path());
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_THAT(problem(), HasSubstr("is not the folder of a job: it has no job.json"));
    write_text(folder.path("job.json"), "{\"carom_farm_job\": 3}");
    EXPECT_THAT(problem(), HasSubstr("was written by another version of carom"));
    write_text(folder.path("job.json"), "[1, 2");
    EXPECT_THAT(problem(), HasSubstr("is no JSON object"));
    write_text(folder.path("job.json"), "{\"carom_farm_job\": 4, \"workers\": \"many\"}");
    EXPECT_THAT(problem(), HasSubstr("'workers' is no number: many"));
    write_text(folder.path("job.json"), "{\"carom_farm_job\": 2, \"workers\": [[1]]}");
    EXPECT_THAT(problem(), HasSubstr("'workers' is neither a text nor a number"));
    FarmJob job = make_job(folder.path());
    job.workers = 0;
    write_job(job);
    EXPECT_THAT(problem(), HasSubstr("has no workers, or no time or processor for them"));
    std::filesystem::remove(folder.path("job.json"));
    ASSERT_EQ(::mkfifo(folder.path("job.json").c_str(), 0600), 0);  // reading it would never end
    EXPECT_THAT(problem(), HasSubstr("/job.json' is no record"));
}

TEST(FarmJob, Folders_AreNamedAfterTheFilmWithSimpleCharacters) {
    const ScratchFolder store;
    const std::string film = "/films/it's $HOME 100 %j.mp4";
    const std::string first = make_job_folder(store.path(), film, Readers::none);
    const std::string second = make_job_folder(store.path(), film, Readers::none);
    EXPECT_THAT(first, ::testing::MatchesRegex(".*/farm/it_s__HOME_100__j-[0-9a-f]{6}-1"));
    EXPECT_NE(first, second);
    write_job(make_job(first));
    EXPECT_THAT(job_folders(store.path()), ElementsAre(first));
}

/// The process's mask, for the lifetime of the object.
class Umask {
  public:
    explicit Umask(mode_t mask) : before_(::umask(mask)) {}
    ~Umask() { ::umask(before_); }
    Umask(const Umask&) = delete;
    Umask& operator=(const Umask&) = delete;

  private:
    mode_t before_;
};

unsigned mode_of(const std::string& path) {
    return static_cast<unsigned>(std::filesystem::status(path).permissions());
}

TEST(FarmJob, Folders_HaveTheAskedModesWhateverTheMask) {
    for (const mode_t mask : {0U, 022U, 077U}) {
        const Umask changed(mask);
        for (const auto& [readers, mode] :
             {std::pair{Readers::none, 0700U}, {Readers::group, 02750U}, {Readers::all, 0755U}}) {
            const ScratchFolder folder;
            const std::string store = folder.path("new/store");
            make_store(store + (readers == Readers::none ? "" : "/"), readers);
            const std::string job = make_job_folder(store, "/film.mp4", readers);
            EXPECT_EQ(mode_of(store), mode);
            EXPECT_EQ(mode_of(job), mode);
        }
    }
}

TEST(FarmJob, WhoeverMayReadTheFolder_MayReadWhatIsMadeInIt) {
    const Umask own(077);
    const ScratchFolder folder;
    for (const auto& [mode, left] :
         {std::pair{0700, 077U}, {0750, 027U}, {02755, 022U}, {0777, 022U}}) {
        const Umask again(077);
        std::filesystem::permissions(folder.path(), std::filesystem::perms(mode));
        let_readers_read(folder.path());
        const mode_t mask = ::umask(0);
        EXPECT_EQ(mask, left) << mode;
    }
}

TEST(FarmJob, FolderOfAnotherUser_IsNotOwn) {
    const ScratchFolder folder;
    EXPECT_TRUE(is_own(folder.path()));
    EXPECT_FALSE(is_own(folder.path("missing")));
    if (::geteuid() == 0) {
        constexpr uid_t kOther = 65534;
        std::filesystem::create_directory_symlink(folder.path(), folder.path("link"));
        EXPECT_TRUE(is_own(folder.path("link")));
        ASSERT_EQ(::lchown(folder.path("link").c_str(), kOther, kOther), 0);
        EXPECT_FALSE(is_own(folder.path("link"))) << "it would be another user's name for it";
        ASSERT_EQ(::chown(folder.path().c_str(), kOther, kOther), 0);
        EXPECT_FALSE(is_own(folder.path()));
    }
}

TEST(FarmJob, StoreThatExists_KeepsItsMode) {
    const ScratchFolder folder;
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0750));
    make_store(folder.path(), Readers::none);
    EXPECT_EQ(mode_of(folder.path()), 0750U);
}

TEST(FarmJob, FoldersThatOthersMayWrite_LetNobodyReplaceAnothersJob) {
    const Umask everybody(0);
    const ScratchFolder store;
    std::filesystem::permissions(store.path(), std::filesystem::perms(0777));
    (void)make_job_folder(store.path(), "/film.mp4", Readers::none);
    EXPECT_EQ(mode_of(store.path("farm")), 01777U);
    EXPECT_EQ(mode_of(store.path()), 01777U) << "or another folder farm could be put there";
}

TEST(FarmJob, Records_AreReadAgain) {
    const ScratchFolder folder;
    const FarmJob job = make_job(folder.path());
    EXPECT_FALSE(read_round(job));
    const Round round{{11, 12},     {7, 12},      3,     {40, 123456789012}, 2, 5, 4, 8, 2,
                      {"n1", "n1"}, {"n0", "n2"}, "late"};
    write_round(job, round);
    EXPECT_EQ(read_round(job), round);
    EXPECT_EQ(numbers_of(round).object(), "{\"frames\":11,\"film\":12}");
    EXPECT_FALSE(read_end(job));
    write_end(job, {"failed", "no \"space\" left"});
    EXPECT_EQ(read_end(job)->message, "no \"space\" left");
    remove_end(job);
    EXPECT_FALSE(read_end(job));
}

TEST(WorkerFile, Notes_AreReadByNameAndBrokenOnesLeftOut) {
    const ScratchFolder folder;
    const FarmJob job = make_job(folder.path());
    std::filesystem::create_directory(folder.path("workers"));
    WorkerNote note;
    note.state = "working";
    note.frame = 5;
    note.heartbeat = 9;
    for (const char* name : {"2_1", "2_0"}) {
        note.name = name;
        write_worker(job, note);
    }
    write_text(folder.path("workers/3.json"), "{\"name\":");
    const std::vector<WorkerNote> notes = read_workers(job);
    ASSERT_EQ(notes.size(), 2U);
    EXPECT_EQ(notes[0].name, "2_0");
    EXPECT_EQ(notes[1].heartbeat, 9);
}

}  // namespace
}  // namespace carom::farm
