#include "pipeline/server/outbox.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace {

using carom::server::Outbox;
using carom::server::SocketId;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> taken(Outbox& outbox, SocketId socket) {
    std::vector<std::string> texts;
    while (const auto message = outbox.next(socket)) {
        texts.push_back(message->data);
    }
    return texts;
}

TEST(Outbox, SameSlot_TakesThePlaceOfTheOlder) {
    Outbox outbox(10, 1000);
    outbox.open(1);
    outbox.add(1, {false, "one", ""});
    outbox.add(1, {false, "a1", "a"});
    outbox.add(1, {false, "b1", "b"});
    outbox.add(1, {false, "a2", "a"});
    outbox.add(1, {false, "two", ""});
    EXPECT_THAT(taken(outbox, 1), ElementsAre("one", "a2", "b1", "two"));
    outbox.add(1, {false, "a3", "a"});  // nothing waits in the slot any more
    EXPECT_THAT(taken(outbox, 1), ElementsAre("a3"));
}

// A page begins anew with a welcome: what comes after it must not arrive before it.
TEST(Outbox, SameSlot_DoesNotOvertakeAMessageWithoutASlot) {
    Outbox outbox(10, 1000);
    outbox.open(1);
    outbox.add(1, {false, "old problems", "problems"});
    outbox.add(1, {false, "old shot", "shot"});
    outbox.add(1, {false, "welcome", ""});
    outbox.add(1, {false, "problems", "problems"});
    outbox.add(1, {false, "shot", "shot"});
    outbox.add(1, {false, "newer problems", "problems"});
    EXPECT_THAT(taken(outbox, 1), ElementsAre("welcome", "newer problems", "shot"));
}

TEST(Outbox, All_AreTheOpenSockets) {
    Outbox outbox(10, 1000);
    outbox.add(0, {false, "too early", ""});
    outbox.open(1);
    outbox.open(2);
    outbox.add(0, {false, "all", ""});
    outbox.close(2);
    EXPECT_THAT(taken(outbox, 1), ElementsAre("all"));
    EXPECT_THAT(taken(outbox, 2), IsEmpty());
}

TEST(Outbox, Changes_AreToldOnce) {
    Outbox outbox(10, 1000);
    outbox.open(1);
    outbox.open(2);
    outbox.open(3);
    outbox.add(3, {false, "x", ""});
    outbox.add(1, {false, "x", ""});
    outbox.add(1, {false, "y", ""});
    EXPECT_THAT(outbox.take_changes().filled, ElementsAre(1, 3));
    EXPECT_THAT(outbox.take_changes().filled, IsEmpty());
}

TEST(Outbox, TooMany_Overfilled) {
    Outbox outbox(2, 1000);
    outbox.open(1);
    for (int i = 0; i < 100; ++i) {
        outbox.add(1, {false, std::string(1000, 'x'), "slot"});  // only one of them waits
    }
    outbox.add(1, {false, "one", ""});
    outbox.add(1, {false, "two", ""});
    EXPECT_THAT(outbox.take_changes().overfilled, IsEmpty());
    outbox.add(1, {false, "three", ""});
    const Outbox::Changes changes = outbox.take_changes();
    EXPECT_THAT(changes.overfilled, ElementsAre(1));
    EXPECT_THAT(changes.filled, IsEmpty());
    EXPECT_THAT(taken(outbox, 1), IsEmpty());
}

TEST(Outbox, TooLong_Overfilled) {
    Outbox outbox(100, 1000);
    outbox.open(1);
    outbox.add(1, {false, std::string(600, 'x'), ""});
    EXPECT_EQ(outbox.next(1)->data.size(), 600);
    outbox.add(1, {false, std::string(600, 'x'), ""});
    EXPECT_THAT(outbox.take_changes().overfilled, IsEmpty());
    outbox.add(1, {false, std::string(600, 'x'), ""});
    EXPECT_THAT(outbox.take_changes().overfilled, ElementsAre(1));
}

}  // namespace
