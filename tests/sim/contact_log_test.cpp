// Stretches of contact from the loads of steps and taps.
#include "sim/scheduler/contact_log.h"

#include <cmath>

#include <gtest/gtest.h>

namespace carom::sim {
namespace {

constexpr double kStep = 1.0 / 1024;  // s

/// Adds steps of a contact whose force (N) and slip (m/s) are functions of time.
template <class Force, class Slip>
void press(ContactLog& log, double from, double to, Force force, Slip slip) {
    for (double t = from; t < to; t += kStep) {
        const double middle = t + 0.5 * kStep;
        log.add("box", "floor", {t, t + kStep, force(middle) * kStep, slip(middle), 0});
    }
}

auto always(double value) {
    return [value](double) { return value; };
}

double impulse_of(const std::vector<LastingContact>& contacts) {
    double sum = 0;
    for (const LastingContact& contact : contacts) {
        sum += contact.normal_force * (contact.to - contact.from);
    }
    return sum;
}

TEST(ContactLog_ConstantContact, IsOneStretch) {
    ContactLog log;
    press(log, 1, 3, always(2.5), always(0.25));
    const std::vector<LastingContact> contacts = log.take();
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_EQ(contacts[0].a, "box");
    EXPECT_EQ(contacts[0].b, "floor");
    EXPECT_EQ(contacts[0].from, 1);
    EXPECT_EQ(contacts[0].to, 3);
    EXPECT_NEAR(contacts[0].normal_force, 2.5, 1e-12);
    EXPECT_NEAR(contacts[0].slip, 0.25, 1e-12);
}

TEST(ContactLog_GrowingSlip, IsSplitWhereItHasGrownByAQuarter) {
    ContactLog log;
    const auto slip = [](double t) { return 0.1 + t; };
    press(log, 0, 1, always(3), slip);
    const std::vector<LastingContact> contacts = log.take();
    ASSERT_GT(contacts.size(), 8U);
    EXPECT_LT(contacts.size(), 30U);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const LastingContact& contact = contacts[i];
        EXPECT_EQ(contact.from, i == 0 ? 0 : contacts[i - 1].to);
        EXPECT_NEAR(contact.normal_force, 3, 1e-12);
        EXPECT_NEAR(contact.slip, slip(0.5 * (contact.from + contact.to)), 1e-12);
        const double first = slip(contact.from + 0.5 * ContactLog::kPiece);
        const double last = slip(contact.to - 0.5 * ContactLog::kPiece);
        EXPECT_LT(last, first * ContactLog::kJoinedSlips + 2 * kStep);
    }
    EXPECT_EQ(contacts.back().to, 1);
}

TEST(ContactLog_ForceThatJumps, IsSplitThere) {
    ContactLog log;
    press(
        log, 0, 1, [](double t) { return t < 0.5 ? 2.0 : 6.0; }, always(0.2));
    const std::vector<LastingContact> contacts = log.take();
    ASSERT_EQ(contacts.size(), 3U);
    EXPECT_NEAR(contacts[0].normal_force, 2, 1e-12);
    EXPECT_LE(contacts[1].to - contacts[1].from, ContactLog::kPiece + kStep);  // with the jump
    EXPECT_NEAR(contacts[2].normal_force, 6, 1e-12);
    EXPECT_NEAR(impulse_of(contacts), 4, 1e-12);
}

TEST(ContactLog_PairAtRest, IsNotRecorded) {
    ContactLog log;
    press(log, 0, 1, always(5), always(0.9 * kStillSpeed));
    EXPECT_TRUE(log.take().empty());
}

TEST(ContactLog_RollingContact, IsRecordedWithoutSlip) {
    ContactLog log;
    for (int i = 0; i < 100; ++i) {
        log.add("ball", "box", {i * kStep, (i + 1) * kStep, 1.5 * kStep, 0, 0.3});
    }
    const std::vector<LastingContact> contacts = log.take();
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_EQ(contacts[0].slip, 0);
    EXPECT_NEAR(contacts[0].normal_force, 1.5, 1e-12);
}

TEST(ContactLog_ContactThatComesToRest, EndsThere) {
    ContactLog log;
    press(log, 0, 1, always(5), [](double t) { return t < 0.25 ? 1.0 : 0.0; });
    const std::vector<LastingContact> contacts = log.take();
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_EQ(contacts[0].to, 0.25);
    EXPECT_NEAR(contacts[0].normal_force, 5, 1e-12);
}

TEST(ContactLog_ShortPause, IsPartOfTheStretch) {
    for (const bool rests : {false, true}) {
        ContactLog log;
        press(log, 0, 16 * kStep, always(5), always(1));
        if (rests) {
            press(log, 16 * kStep, 18 * kStep, always(5), always(0));
        }
        press(log, 18 * kStep, 20 * kStep, always(5), always(1));
        const std::vector<LastingContact> contacts = log.take();
        ASSERT_EQ(contacts.size(), 1U);
        EXPECT_EQ(contacts[0].to, 20 * kStep);
        EXPECT_NEAR(contacts[0].normal_force, rests ? 5 : 4.5, 1e-12);
        EXPECT_NEAR(contacts[0].slip, rests ? 0.9 : 1, 1e-12);
    }
}

TEST(ContactLog_LongPause, DividesTwoStretches) {
    for (const bool rests : {false, true}) {
        ContactLog log;
        press(log, 0, 16 * kStep, always(5), always(1));
        if (rests) {
            press(log, 16 * kStep, 19 * kStep, always(5), always(0));
        }
        press(log, 19 * kStep, 32 * kStep, always(5), always(1));
        const std::vector<LastingContact> contacts = log.take();
        ASSERT_EQ(contacts.size(), 2U);
        EXPECT_EQ(contacts[0].to, 16 * kStep);
        EXPECT_EQ(contacts[1].from, 19 * kStep);
        EXPECT_NEAR(contacts[0].normal_force, 5, 1e-12);
        EXPECT_NEAR(contacts[1].normal_force, 5, 1e-12);
    }
}

TEST(ContactLog_ContactOfOneStep, IsLeftOut) {
    ContactLog log;
    press(log, 0, kStep, always(100), always(1));
    press(log, 1, 1 + kStep, always(100), always(1));
    EXPECT_TRUE(log.take().empty());
}

TEST(ContactLog_Taps, AreOneContactWithTheirMeanForce) {
    constexpr double kInterval = 1.0 / 8192;
    ContactLog log;
    for (int i = 0; i <= 819; ++i) {
        const double time = i * kInterval;
        log.add("one", "two", {time, time, 2e-4, 0.5, 0});
    }
    log.add("one", "two", {5, 5, 2e-4, 0.5, 0});  // alone
    const std::vector<LastingContact> contacts = log.take();
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_EQ(contacts[0].from, 0);
    EXPECT_EQ(contacts[0].to, 819 * kInterval);
    EXPECT_NEAR(contacts[0].normal_force, 2e-4 / kInterval, 1e-9);
    EXPECT_NEAR(contacts[0].slip, 0.5, 1e-12);
}

TEST(ContactLog_SeveralPairs, AreInOrderOfTheirBeginnings) {
    ContactLog log;
    for (int i = 0; i < 64; ++i) {
        const double from = i * kStep;
        for (const auto& [a, b, begin] :
             {std::tuple{"two", "three", 0}, std::tuple{"one", "two", 32},
              std::tuple{"one", "floor", 0}}) {
            if (i >= begin) {
                log.add(a, b, {from, from + kStep, kStep, 1, 0});
            }
        }
    }
    const std::vector<LastingContact> contacts = log.take();
    ASSERT_EQ(contacts.size(), 3U);
    EXPECT_EQ(contacts[0].a + contacts[0].b, "onefloor");
    EXPECT_EQ(contacts[1].a + contacts[1].b, "twothree");
    EXPECT_EQ(contacts[2].a + contacts[2].b, "onetwo");
}

TEST(ContactLog_MoreThanItsLimit, KeepsTheGreatestImpulses) {
    constexpr int kMost = 10;
    ContactLog log(kMost);
    for (int i = 0; i < 95; ++i) {  // each a stretch of its own; the forces are 1 to 95 N
        const double force = 1 + (i * 37) % 95;
        press(log, i, i + 0.01, always(force), always(1));
    }
    const std::vector<LastingContact> contacts = log.take();
    ASSERT_EQ(contacts.size(), 10U);
    for (const LastingContact& contact : contacts) {
        EXPECT_GT(contact.normal_force, 85.5);
    }
}

}  // namespace
}  // namespace carom::sim
