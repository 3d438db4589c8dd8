// A page asks the session for the annotations in the scene.
#include <span>

#include "tests/pipeline/studio/session_fixture.h"

namespace carom::studio {
namespace {

class AnnotationsSession : public StudioSession {
  protected:
    /// Waits for a binary message of that slot.
    std::string wait_for_binary(const std::string& slot) {
        std::unique_lock lock(mutex_);
        std::string data;
        wake_.wait_for(lock, kPatience, [&] {
            for (const Outgoing& one : sent_) {
                if (one.binary && one.slot == slot) {
                    data = one.data;
                }
            }
            return !data.empty();
        });
        return data;
    }
};

TEST_F(AnnotationsSession, Page_GetsTheAnnotationsOfItsShot) {
    const std::string text = read_file(path("shot.yaml"));
    write_file(path("shot.yaml"), text + "\nannotations:\n  - path: {of: cue, part: whole}\n");
    start();
    static_cast<void>(wait_for<Problems>([](const Problems& all) { return all.complete; }));
    SeeAnnotations see;
    see.q = 7;
    see.v = 1;
    see.view.position = {0, -3, 2};
    say(see);
    const std::string data = wait_for_binary("annotations");
    ASSERT_FALSE(data.empty());
    const Unpacked message = unpack(std::as_bytes(std::span(data)));
    const auto& head = std::get<AnnotationsHead>(message.head);
    EXPECT_EQ(head.q, 7);
    EXPECT_EQ(head.v, 1);
    ASSERT_EQ(head.shapes.size(), 1U);
    EXPECT_GT(head.shapes.front().points, 3);
    EXPECT_EQ(message.payload.size(),
              static_cast<std::size_t>(head.shapes.front().points) * 4 * sizeof(double));
    const std::lock_guard lock(mutex_);
    EXPECT_EQ(sent_.back().to, 1U) << "only the page that asked";
}

}  // namespace
}  // namespace carom::studio
