// Live mode: a save is seen whichever way an editor saves, and the server tells
// its page to nobody who does not know the secret. Over loopback only.
#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <fstream>
#include <future>
#include <thread>

#include "course/cli/live.h"
#include "course/runner/catch2.h"
#include "course/runner/exercises.h"
#include "course/runner/temporary_folder.h"

using namespace course;

namespace fs = std::filesystem;

namespace {

void save(const fs::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

/// As most editors do it: a new file takes the place of the old one.
void save_by_rename(const fs::path& file, const std::string& text) {
    const fs::path beside = file.string() + "~";
    save(beside, text);
    fs::rename(beside, file);
}

void stop(const DescriptorPair& pipe) {
    REQUIRE(write_all(pipe.second.get(), "x", 1));
}

/// A file that is watched, by a thread that is never left behind.
class Watched {
public:
    Watched() : file(folder / "walk.cpp"), watch_((save(file, "old"), file)) {}

    void begin() {
        result_ = std::async(std::launch::async, [this] {
            return wait_for_save(watch_, stop_.first.get());
        });
    }

    bool is_waiting(std::chrono::milliseconds most) {
        return result_.wait_for(most) == std::future_status::timeout;
    }

    /// What was saved; "nothing" when that was not seen in time.
    std::string seen() {
        if (is_waiting(std::chrono::seconds(20))) stop(stop_);
        return result_.get() ? read_file(file) : "nothing";
    }

    bool ends_when_stopped() {
        stop(stop_);
        return !result_.get();
    }

private:
    TemporaryFolder folder;

public:
    const fs::path file;

private:
    FileWatch watch_;
    DescriptorPair stop_ = pipe_pair();
    std::future<bool> result_;
};

struct Answer {
    int status = 0;
    std::string head;
    std::string body;
};

Descriptor connected(const char* host, int port) {
    Descriptor socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(port));
    ::inet_pton(AF_INET, host, &to.sin_addr);
    const auto* address = reinterpret_cast<const sockaddr*>(&to);
    if (::connect(socket.get(), address, sizeof to) != 0) return {};
    // Less than news are waited for.
    const timeval patience{10, 0};
    ::setsockopt(socket.get(), SOL_SOCKET, SO_RCVTIMEO, &patience,
                 sizeof patience);
    return socket;
}

/// Sends a whole request, as it stands, and reads the answer to its end.
Answer ask_raw(int port, const std::string& request) {
    const Descriptor socket = connected("127.0.0.1", port);
    REQUIRE(socket);
    REQUIRE(write_all(socket.get(), request.data(), request.size()));
    std::string text;
    char piece[4096];
    for (ssize_t n; (n = ::read(socket.get(), piece, sizeof piece)) > 0;)
        text.append(piece, static_cast<std::size_t>(n));
    Answer answer;
    const auto end = text.find("\r\n\r\n");
    if (text.rfind("HTTP/1.1 ", 0) != 0 || end == std::string::npos)
        return answer;
    answer.status = std::stoi(text.substr(9));
    answer.head = text.substr(0, end + 2);
    answer.body = text.substr(end + 4);
    return answer;
}

Answer ask(const PageServer& server, const std::string& path) {
    return ask_raw(server.port(),
                   fmt::format("GET {} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n\r\n",
                               path, server.port()));
}

/// Where the server's three things are: "/<secret>/".
std::string root(const PageServer& server) {
    const std::string address = server.address();
    return address.substr(address.find('/', std::string("http://").size()));
}

/// A server, or none and the reason.
std::unique_ptr<PageServer> started(int port = 0) {
    try {
        return std::make_unique<PageServer>(port);
    } catch (const CannotServe& error) {
        WARN(error.what());
        return nullptr;
    }
}

bool has_line(const Answer& answer, const std::string& line) {
    return answer.head.find("\r\n" + line + "\r\n") != std::string::npos;
}

}  // namespace

TEST_CASE("a save is seen, however the editor saves") {
    Watched watched;
    const fs::path beside = watched.file.string() + "~";
    save(beside, "new");
    watched.begin();
    // So that it sleeps, and is woken by the save.
    REQUIRE(watched.is_waiting(std::chrono::milliseconds(200)));
    SECTION("in place") {
        save(watched.file, "new");
    }
    SECTION("by another file") {
        save_by_rename(watched.file, "new");
    }
    SECTION("by taking the old one away first") {
        fs::remove(watched.file);
        save(watched.file, "new");
    }
    CHECK(watched.seen() == "new");
}

TEST_CASE("a hundred saves in quick succession end with the last text") {
    Watched watched;
    std::string last;
    watched.begin();
    for (int k = 1; k <= 100; ++k)
        save_by_rename(watched.file, fmt::format("text {}", k));
    for (int k = 0; k < 100 && last != "text 100"; ++k) {
        last = watched.seen();
        REQUIRE(last != "nothing");
        watched.begin();
    }
    CHECK(last == "text 100");
    CHECK(watched.ends_when_stopped());
}

TEST_CASE("what was saved before one waits is not missed") {
    Watched watched;
    save_by_rename(watched.file, "new");
    watched.begin();
    CHECK(watched.seen() == "new");
}

TEST_CASE("another file or no file is no save") {
    Watched watched;
    watched.begin();
    save(watched.file.parent_path() / "other.cpp", "new");
    fs::remove(watched.file);
    CHECK(watched.is_waiting(std::chrono::milliseconds(600)));
    CHECK(watched.ends_when_stopped());
}

TEST_CASE("the frame, the page and the news are told to who knows the secret") {
    const auto server = started();
    if (!server) return;
    server->show("<p>first</p>");
    const Answer frame = ask(*server, root(*server));
    CHECK(frame.status == 200);
    CHECK(frame.body.find("connect-src 'self'") != std::string::npos);
    CHECK(has_line(frame, "Cache-Control: no-store"));
    CHECK(has_line(frame, "Referrer-Policy: no-referrer"));
    CHECK(has_line(frame, "Content-Security-Policy: frame-ancestors 'self'"));
    CHECK(ask(*server, root(*server) + "page").body == "<p>first</p>");
    const Answer news = ask(*server, root(*server) + "news?after=0");
    CHECK(news.status == 200);
    CHECK(news.body.empty());
    CHECK(has_line(news, "Version: 1"));
    CHECK(has_line(news, "Page: 1"));
}

TEST_CASE("a complaint leaves the page as it is") {
    const auto server = started();
    if (!server) return;
    server->show("<p>first</p>");
    server->complain("line 12: expected ';'");
    const Answer news = ask(*server, root(*server) + "news?after=1");
    CHECK(news.body == "line 12: expected ';'");
    CHECK(has_line(news, "Version: 2"));
    CHECK(has_line(news, "Page: 1"));
    CHECK(ask(*server, root(*server) + "page").body == "<p>first</p>");
    server->show("<p>second</p>");
    CHECK(ask(*server, root(*server) + "news?after=2").body.empty());
    CHECK(ask(*server, root(*server) + "page").body == "<p>second</p>");
}

TEST_CASE("who lacks the secret gets nothing") {
    const auto server = started();
    if (!server) return;
    server->show("the page");
    const std::string secret = root(*server);
    CHECK(secret.size() == 34);
    std::string wrong = secret;
    wrong[1] = wrong[1] == '0' ? '1' : '0';
    const std::string nearly = secret.substr(0, secret.size() - 1);
    for (const std::string& path :
         {std::string("/"), std::string("/page"), std::string("//page"),
          wrong + "page", wrong + "news", nearly, "/x" + secret + "page",
          std::string("/../page"), "/" + std::string(8000, 'a')}) {
        const Answer answer = ask(*server, path);
        INFO(path);
        CHECK(answer.status / 100 == 4);
        CHECK(answer.body.find("the page") == std::string::npos);
        CHECK(answer.head.find(secret.substr(1, 32)) == std::string::npos);
    }
    CHECK(ask(*server, wrong + "page").status == 403);
    CHECK(ask(*server, secret + "pages").status == 404);
    CHECK(ask(*server, secret + "../page").status == 404);
}

TEST_CASE("another name that leads here is refused, and all but GET") {
    const auto server = started();
    if (!server) return;
    server->show("the page");
    const int port = server->port();
    const std::string path = root(*server) + "page";
    for (const std::string& host :
         {fmt::format("evil.example:{}", port),
          fmt::format("localhost:{}", port), std::string("127.0.0.1"),
          fmt::format("127.0.0.1:{}", port + 1),
          fmt::format("127.0.0.1:{}.evil.example", port)}) {
        INFO(host);
        CHECK(ask_raw(port, fmt::format("GET {} HTTP/1.1\r\nHost: {}\r\n\r\n",
                                        path, host))
                  .status == 403);
    }
    CHECK(ask_raw(port, fmt::format("GET {} HTTP/1.1\r\n\r\n", path)).status ==
          403);
    for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "HEAD"}) {
        INFO(method);
        CHECK(ask_raw(port, fmt::format("{} {} HTTP/1.1\r\nHost: 127.0.0.1:{}"
                                        "\r\nContent-Length: 0\r\n\r\n",
                                        method, path, port))
                  .status == 405);
    }
}

TEST_CASE("only this address of this machine listens, and each port once") {
    const auto server = started();
    if (!server) return;
    CHECK_FALSE(connected("127.0.0.2", server->port()));
    CHECK_THROWS_AS(PageServer(server->port()), CannotServe);
    const auto other = started();
    CHECK(root(*server) != root(*other));
}

TEST_CASE("bytes that are no request do not end the server") {
    const auto server = started();
    if (!server) return;
    server->show("the page");
    for (const std::string& bytes :
         {std::string("\r\n\r\n"), std::string("GET\r\n\r\n"),
          std::string(100, '\0') + "\r\n\r\n", std::string(70'000, 'x'),
          "GET /" + std::string(70'000, 'x') + " HTTP/1.1\r\n\r\n"}) {
        const Descriptor socket = connected("127.0.0.1", server->port());
        REQUIRE(socket);
        static_cast<void>(
            ::send(socket.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL));
    }
    CHECK(ask(*server, root(*server) + "page").body == "the page");
}

TEST_CASE("who waits for news hears them when they are there, or at the end") {
    auto server = started();
    if (!server) return;
    const std::string path = root(*server) + "news?after=0";
    auto news =
        std::async(std::launch::async, [&] { return ask(*server, path); });
    SECTION("news") {
        server->complain("line 3");
        CHECK(news.get().body == "line 3");
    }
    SECTION("the end") {
        // Until it waits there, it cannot be told of the end.
        CHECK(news.wait_for(std::chrono::milliseconds(300)) ==
              std::future_status::timeout);
        const PageServer* gone = server.release();
        delete gone;
        CHECK(news.get().status == 200);
    }
}

TEST_CASE("a save makes a new page, or says what keeps it from being made") {
    const auto server = started();
    if (!server) return;
    const TemporaryFolder folder;
    const fs::path file = folder / "walk.cpp";
    save(file, "good 1");
    FileWatch watch(file);
    const DescriptorPair pipe = pipe_pair();
    const auto make = [&] {
        const std::string text = read_file(file);
        if (text.rfind("good", 0) != 0)
            throw std::runtime_error("line 1: " + text);
        return "<p>" + text;
    };
    auto following = std::async(std::launch::async, [&] {
        follow(watch, *server, make, pipe.first.get());
    });
    const auto after = [&](int version) {
        return ask(*server,
                   fmt::format("{}news?after={}", root(*server), version));
    };
    CHECK(has_line(after(0), "Page: 1"));
    save_by_rename(file, "bad");
    CHECK(after(1).body == "line 1: bad");
    CHECK(ask(*server, root(*server) + "page").body == "<p>good 1");
    save(file, "good 2");
    CHECK(has_line(after(2), "Page: 2"));
    CHECK(ask(*server, root(*server) + "page").body == "<p>good 2");
    stop(pipe);
    CHECK(following.wait_for(std::chrono::seconds(20)) ==
          std::future_status::ready);
}

TEST_CASE("the large sentence is the first error, with its line") {
    CHECK(large_sentence("walk.cpp: In function 'int f()':\n"
                         "walk.cpp:3:9: warning: unused variable 'j'\n"
                         "walk.cpp:12:5: error: expected ';' before '}'\n"
                         "walk.cpp:14:5: error: another\n") ==
          "line 12: expected ';' before '}'");
    CHECK(
        large_sentence("a b.cpp:1:10: fatal error: x.h: No such file\nmore") ==
        "line 1: x.h: No such file");
    // In a header: the line that led there.
    CHECK(large_sentence("algorithm.h:90:5:   required from 'void sort(T)'\n"
                         "walk.cpp:7:14:   required from here\n"
                         "algorithm.h:1950:22: error: no match for '<'\n") ==
          "line 7: no match for '<'");
    CHECK(large_sentence("the first line\nthe second") == "the first line");
    CHECK(large_sentence(": error: \n") == ": error: ");
    CHECK(large_sentence("12: error: x") == "12: error: x");
    CHECK(large_sentence("").empty());
}

TEST_CASE("Ctrl-C ends live mode in order") {
    if (!started()) return;
    const TemporaryFolder folder;
    int made = 0;
    const auto make = [&made] {
        ++made;
        ::raise(SIGINT);
        return std::string("<p>");
    };
    CHECK(live(folder / "walk.cpp", 0, make) == 0);
    CHECK(made == 1);
}
