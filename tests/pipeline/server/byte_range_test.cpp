#include "pipeline/server/byte_range.h"

#include <gmock/gmock.h>

namespace {

using carom::server::asked_range;
using carom::server::AskedRange;
using carom::server::RangeKind;

TEST(ByteRange, EmptyResource_HasNoPart) {
    EXPECT_EQ(asked_range("", 0).kind, RangeKind::whole);
    EXPECT_EQ(asked_range("bytes=0-", 0).kind, RangeKind::outside);
    EXPECT_EQ(asked_range("bytes=-1", 0).kind, RangeKind::outside);
}

TEST(ByteRange, AnyPart_IsInside) {
    for (const char* field : {"bytes=0-0", "bytes=0-", "bytes=3-", "bytes=-3", "bytes=-99",
                              "bytes=9-9", "bytes=2-99", "bytes=9-18446744073709551615"}) {
        const AskedRange asked = asked_range(field, 10);
        EXPECT_EQ(asked.kind, RangeKind::part) << field;
        EXPECT_LT(asked.range.begin, asked.range.end) << field;
        EXPECT_LE(asked.range.end, 10) << field;
    }
}

TEST(ByteRange, WhatIsNoRange_IsIgnored) {
    for (const char* field :
         {"bytes=", "bytes=-", "bytes=--1", "bytes=1", "bytes=1-x", "bytes=+1-2", "bytes= 1-2",
          "bytes=1-2-3", "bytes=18446744073709551616-", "bytes=1-99999999999999999999",
          "Bytes=1-2"}) {
        EXPECT_EQ(asked_range(field, 10).kind, RangeKind::whole) << field;
    }
}

}  // namespace
