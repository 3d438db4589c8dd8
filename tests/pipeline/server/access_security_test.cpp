// Who may ask: keys, Host and Origin, over real sockets.
#include <memory>
#include <string>

#include <gmock/gmock.h>

#include "pipeline/server/secret.h"
#include "tests/pipeline/server/running_server.h"

namespace {

using carom::testing::HttpAnswer;
using carom::testing::RunningServer;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::string get(const std::string& target, const std::string& lines) {
    return "GET " + target + " HTTP/1.1\r\n" + lines + "\r\n";
}

std::string with_last_digit_changed(std::string key) {
    key.back() = key.back() == '0' ? '1' : '0';
    return key;
}

TEST(ServerAccess, NoKey_Unauthorized) {
    RunningServer running;
    const std::string host = "Host: " + running.host() + "\r\n";
    for (const char* target : {"/", "/main.js", "/socket", "/none", "/?key", "/?key=", "/?x=1",
                               "/studio", "/film/1.mp4", "/?read=", "*", "main.js"}) {
        const HttpAnswer answer = running.ask(get(target, host));
        EXPECT_EQ(answer.status, 401) << target;
        EXPECT_THAT(answer.head, Not(HasSubstr("Set-Cookie"))) << target;
    }
    EXPECT_THAT(running.site.asked_paths(), ::testing::IsEmpty());
}

TEST(ServerAccess, WrongKey_Unauthorized) {
    RunningServer running;
    for (const std::string& wrong :
         {with_last_digit_changed(running.key()), running.key() + "0", running.key().substr(1),
          running.key() + "&x=1", std::string(32, '0'), running.read_key()}) {
        const std::string host = "Host: " + running.host() + "\r\n";
        EXPECT_EQ(running.ask(get("/?key=" + wrong, host)).status, 401) << wrong;
        std::string upgrade = running.upgrade(running.origin());
        upgrade.replace(upgrade.find(running.key()), running.key().size(), wrong);
        EXPECT_EQ(running.ask(upgrade).status, 401) << wrong;
    }
    for (const std::string& wrong :
         {with_last_digit_changed(running.read_key()), running.read_key() + "0",
          running.read_key().substr(1), std::string(32, '0'), running.key()}) {
        const std::string host = "Host: " + running.host() + "\r\n";
        EXPECT_EQ(running.ask(get("/" + wrong + "/main.js", host)).status, 401) << wrong;
    }
    EXPECT_THAT(running.site.asked_paths(), ::testing::IsEmpty());
}

// The keys stand behind "#", which a browser sends nowhere, and in no cookie, which it would send
// to the servers of other ports, too.
TEST(ServerAccess, Key_LeadsToThePageWithBothKeys) {
    const RunningServer running;
    const HttpAnswer answer =
        running.ask(get("/?key=" + running.key(), "Host: " + running.host() + "\r\n"));
    EXPECT_EQ(answer.status, 200);
    EXPECT_THAT(answer.head, Not(HasSubstr("Set-Cookie")));
    EXPECT_THAT(answer.head, Not(HasSubstr(running.key())));
    EXPECT_THAT(answer.body, HasSubstr("http-equiv=refresh content='0;url=/studio/#key=" +
                                       running.key() + "&read=" + running.read_key() + "'"));
}

// They hold nothing of the user: a page that is loaded again has no key in its address.
TEST(ServerAccess, FilesOfThePage_NeedNoKeyAndGiveNoResource) {
    RunningServer running({}, {{"/film", {"video/mp4", std::make_shared<std::string>("f"), ""}}});
    EXPECT_EQ(running.ask(running.page_request("/")).status, 200);
    EXPECT_EQ(running.ask(running.page_request("/main.js?x")).status, 200);
    for (const char* target : {"/film", "/none", "//main.js", "/../film", "/socket"}) {
        EXPECT_EQ(running.ask(running.page_request(target)).status, 404) << target;
    }
    EXPECT_THAT(running.site.asked_paths(), ::testing::IsEmpty());
    EXPECT_EQ(running.ask(running.request("/film")).body, "f");
}

TEST(ServerAccess, Key_IsRandomAndLong) {
    const RunningServer one;
    const RunningServer two;
    EXPECT_THAT(one.key(), ::testing::MatchesRegex("[0-9a-f]{32}"));
    EXPECT_NE(one.key(), two.key());
}

TEST(ServerAccess, KeyOfTheSocket_IsFoundAmongOtherProtocols) {
    const RunningServer running;
    const std::string upgrade = running.upgrade(running.origin());
    const std::string protocols = "carom, carom.key." + running.key();
    const auto with = [&](const std::string& other) {
        return std::string(upgrade).replace(upgrade.find(protocols), protocols.size(), other);
    };
    const HttpAnswer answer = running.ask(upgrade);
    EXPECT_EQ(answer.status, 101);
    EXPECT_EQ(answer.field("Sec-WebSocket-Protocol"), "carom");  // the key is not said again
    EXPECT_EQ(running.ask(with("x,carom.key." + running.key() + ",,y")).status, 101);
    for (const std::string& none : {std::string("carom"), std::string(), running.key(),
                                    "xcarom.key." + running.key(), "carom.key" + running.key()}) {
        EXPECT_EQ(running.ask(with(none)).status, 401) << none;
    }
}

TEST(ServerAccess, Cookie_IsNoKey) {
    const RunningServer running;
    const std::string cookie = "Cookie: carom_" + std::to_string(running.port()) + "=" +
                               running.key() + "; carom=" + running.read_key() + "\r\n";
    EXPECT_EQ(running.ask(get("/", "Host: " + running.host() + "\r\n" + cookie)).status, 401);
}

TEST(ServerAccess, WrongMissingOrSecondHost_Forbidden) {
    const RunningServer running;
    const std::string own = "Host: " + running.host() + "\r\n";
    const std::string port = std::to_string(running.port());
    const std::string target = "/" + running.read_key() + "/main.js";
    for (const std::string& hosts :
         {std::string("Host: evil.example\r\n"), std::string("Host: 127.0.0.1\r\n"),
          std::string("Host: 127.0.0.1:1\r\n"), std::string("Host: \r\n"), std::string(),
          "Host: evil.example:" + port + "\r\n", "Host: 127.0.0.1." + port + "\r\n",
          "Host: 127.1:" + port + "\r\n", own + own, own + "Host: evil.example\r\n"}) {
        EXPECT_EQ(running.ask(get(target, hosts)).status, 403) << hosts;
        EXPECT_EQ(running.ask(get("/studio/", hosts)).status, 403) << hosts;
        EXPECT_EQ(running.ask(get("/?key=" + running.key(), hosts)).status, 403) << hosts;
    }
    EXPECT_EQ(running.ask(get(target, own)).status, 200);
    EXPECT_EQ(running.ask(get(target, "Host: localhost:" + port + "\r\n")).status, 200);
}

TEST(ServerAccess, ForeignOrigin_Forbidden) {
    const RunningServer running;
    const std::string port = std::to_string(running.port());
    for (const std::string& origin :
         {std::string("http://evil.example"), std::string("null"), std::string("http://127.0.0.1"),
          std::string("http://127.0.0.1:1"), "https://" + running.host(), running.host(),
          "http://localhost:" + port, "http://" + running.host() + "/",
          "http://" + running.host() + ".evil.example", std::string()}) {
        EXPECT_EQ(running.ask(running.request("/main.js", "Origin: " + origin + "\r\n")).status,
                  403)
            << origin;
        EXPECT_EQ(running.ask(running.upgrade("Origin: " + origin + "\r\n")).status, 403) << origin;
    }
    EXPECT_EQ(running.ask(running.request("/main.js", running.origin())).status, 200);
    EXPECT_EQ(running.ask(running.request("/main.js", running.origin() + running.origin())).status,
              403);
}

TEST(ServerAccess, UpgradeWithoutOrigin_Forbidden) {
    const RunningServer running;
    EXPECT_EQ(running.ask(running.upgrade("")).status, 403);
    EXPECT_EQ(running.ask(running.upgrade(running.origin())).status, 101);
}

TEST(ServerAccess, Answers_AllowNoOtherSite) {
    const RunningServer running;
    for (const HttpAnswer& answer :
         {running.ask(running.request("/main.js")), running.ask(running.request("/none")),
          running.ask("nonsense\r\n\r\n"), running.ask(get("/", ""))}) {
        EXPECT_THAT(answer.head, Not(HasSubstr("Access-Control"))) << answer.head;
        EXPECT_EQ(answer.field("X-Content-Type-Options"), "nosniff");
        EXPECT_EQ(answer.field("Referrer-Policy"), "no-referrer");
        EXPECT_EQ(answer.field("Cross-Origin-Resource-Policy"), "same-origin");
        EXPECT_EQ(answer.field("Cross-Origin-Opener-Policy"), "same-origin");
        EXPECT_EQ(answer.field("Cache-Control"), "no-store");
        const std::string policy = answer.field("Content-Security-Policy");
        EXPECT_THAT(policy, StartsWith("default-src 'self'; script-src 'self'; "));
        EXPECT_THAT(policy, HasSubstr("frame-ancestors 'none'"));
        EXPECT_THAT(policy, Not(HasSubstr("unsafe")));
    }
}

TEST(ServerAccess, Nonce_IsInThePageAndThePolicy) {
    const RunningServer running;
    const RunningServer other;
    const HttpAnswer page = running.ask(running.page_request("/"));
    ASSERT_THAT(page.body, StartsWith("<p>"));
    const std::string nonce = page.body.substr(3);
    EXPECT_THAT(nonce, ::testing::MatchesRegex("[0-9a-f]{32}"));
    EXPECT_NE(nonce, running.key());
    EXPECT_NE(nonce, other.ask(other.page_request("/")).body.substr(3));
    EXPECT_THAT(page.field("Content-Security-Policy"),
                HasSubstr("style-src 'self' 'nonce-" + nonce + "';"));
    EXPECT_EQ(running.ask(running.request("/main.js")).body, "let CAROM_NONCE;");
}

TEST(Secret, Comparison_NeedsTheWholeSecret) {
    using carom::server::is_secret;
    EXPECT_TRUE(is_secret("abc", "abc"));
    for (const char* given : {"", "ab", "abcd", "abd", "bbc", "ABC"}) {
        EXPECT_FALSE(is_secret(given, "abc")) << given;
    }
    EXPECT_FALSE(is_secret("", ""));
}

}  // namespace
