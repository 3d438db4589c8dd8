// Who may ask: key, cookie, Host and Origin, over real sockets.
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

TEST(ServerAccess, NoKey_Unauthorized) {
    const RunningServer running;
    const std::string host = "Host: " + running.host() + "\r\n";
    for (const char* target : {"/", "/main.js", "/socket", "/none", "/?key", "/?key=", "/?x=1"}) {
        const HttpAnswer answer = running.ask(get(target, host));
        EXPECT_EQ(answer.status, 401) << target;
        EXPECT_THAT(answer.head, Not(HasSubstr("Set-Cookie"))) << target;
    }
}

TEST(ServerAccess, WrongKey_Unauthorized) {
    const RunningServer running;
    std::string key = running.key();
    key.back() = key.back() == '0' ? '1' : '0';
    for (const std::string& wrong : {key, running.key() + "0", running.key().substr(1),
                                     running.key() + "&x=1", std::string(32, '0')}) {
        const std::string host = "Host: " + running.host() + "\r\n";
        EXPECT_EQ(running.ask(get("/?key=" + wrong, host)).status, 401) << wrong;
        const std::string cookie =
            "Cookie: carom_" + std::to_string(running.port()) + "=" + wrong + "\r\n";
        EXPECT_EQ(running.ask(get("/", host + cookie)).status, 401) << wrong;
    }
}

TEST(ServerAccess, Key_GivesCookieAndLeavesTheAddressBar) {
    const RunningServer running;
    const HttpAnswer answer =
        running.ask(get("/?key=" + running.key(), "Host: " + running.host() + "\r\n"));
    EXPECT_EQ(answer.status, 200);  // not a redirection, see Responder::welcome
    EXPECT_EQ(answer.field("Set-Cookie"), running.cookie() + "; HttpOnly; SameSite=Strict; Path=/");
    EXPECT_THAT(answer.body, HasSubstr("http-equiv=refresh content='0;url=/'"));
    EXPECT_THAT(answer.body, Not(HasSubstr(running.key())));
}

TEST(ServerAccess, Key_IsRandomAndLong) {
    const RunningServer one;
    const RunningServer two;
    EXPECT_THAT(one.key(), ::testing::MatchesRegex("[0-9a-f]{32}"));
    EXPECT_NE(one.key(), two.key());
}

TEST(ServerAccess, Cookie_IsFoundAmongOthers) {
    const RunningServer running;
    const std::string host = "Host: " + running.host() + "\r\n";
    EXPECT_EQ(running.ask(get("/", host + "Cookie: a=b; " + running.cookie() + " ;c=d\r\n")).status,
              200);
    EXPECT_EQ(running.ask(get("/", host + "Cookie: ;;=; x" + running.cookie() + ";\r\n")).status,
              401);
}

TEST(ServerAccess, CookieOfAnotherPort_Unauthorized) {
    const RunningServer running;
    const RunningServer other;
    EXPECT_EQ(
        running.ask(get("/", "Host: " + running.host() + "\r\nCookie: " + other.cookie() + "\r\n"))
            .status,
        401);
    // Browsers send the cookies of all ports to each.
    EXPECT_EQ(running
                  .ask(get("/", "Host: " + running.host() + "\r\nCookie: " + other.cookie() + "; " +
                                    running.cookie() + "\r\n"))
                  .status,
              200);
}

TEST(ServerAccess, WrongMissingOrSecondHost_Forbidden) {
    const RunningServer running;
    const std::string cookie = "Cookie: " + running.cookie() + "\r\n";
    const std::string own = "Host: " + running.host() + "\r\n";
    const std::string port = std::to_string(running.port());
    for (const std::string& hosts :
         {std::string("Host: evil.example\r\n"), std::string("Host: 127.0.0.1\r\n"),
          std::string("Host: 127.0.0.1:1\r\n"), std::string("Host: \r\n"), std::string(),
          "Host: evil.example:" + port + "\r\n", "Host: 127.0.0.1." + port + "\r\n",
          "Host: 127.1:" + port + "\r\n", own + own, own + "Host: evil.example\r\n"}) {
        EXPECT_EQ(running.ask(get("/", hosts + cookie)).status, 403) << hosts;
        EXPECT_EQ(running.ask(get("/?key=" + running.key(), hosts)).status, 403) << hosts;
    }
    EXPECT_EQ(running.ask(get("/", own + cookie)).status, 200);
    EXPECT_EQ(running.ask(get("/", "Host: localhost:" + port + "\r\n" + cookie)).status, 200);
}

TEST(ServerAccess, ForeignOrigin_Forbidden) {
    const RunningServer running;
    const std::string port = std::to_string(running.port());
    for (const std::string& origin :
         {std::string("http://evil.example"), std::string("null"), std::string("http://127.0.0.1"),
          std::string("http://127.0.0.1:1"), "https://" + running.host(), running.host(),
          "http://localhost:" + port, "http://" + running.host() + "/",
          "http://" + running.host() + ".evil.example", std::string()}) {
        EXPECT_EQ(running.ask(running.request("/", "Origin: " + origin + "\r\n")).status, 403)
            << origin;
        EXPECT_EQ(running.ask(running.upgrade("Origin: " + origin + "\r\n")).status, 403) << origin;
    }
    EXPECT_EQ(running.ask(running.request("/", running.origin())).status, 200);
    EXPECT_EQ(running.ask(running.request("/", running.origin() + running.origin())).status, 403);
}

TEST(ServerAccess, UpgradeWithoutOrigin_Forbidden) {
    const RunningServer running;
    EXPECT_EQ(running.ask(running.upgrade("")).status, 403);
    EXPECT_EQ(running.ask(running.upgrade(running.origin())).status, 101);
}

TEST(ServerAccess, UpgradeWithoutCookie_Unauthorized) {
    const RunningServer running;
    std::string request = running.upgrade(running.origin());
    request.erase(request.find("Cookie: "), running.cookie().size() + 10);
    EXPECT_EQ(running.ask(request).status, 401);
}

TEST(ServerAccess, Answers_AllowNoOtherSite) {
    const RunningServer running;
    for (const HttpAnswer& answer :
         {running.ask(running.request("/")), running.ask(running.request("/none")),
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
    const HttpAnswer page = running.ask(running.request("/"));
    ASSERT_THAT(page.body, StartsWith("<p>"));
    const std::string nonce = page.body.substr(3);
    EXPECT_THAT(nonce, ::testing::MatchesRegex("[0-9a-f]{32}"));
    EXPECT_NE(nonce, running.key());
    EXPECT_NE(nonce, other.ask(other.request("/")).body.substr(3));
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
