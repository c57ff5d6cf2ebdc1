#include "course/player/page_server.h"

#ifdef COURSE_HAS_HTTPLIB
#include <fmt/format.h>
#include <httplib.h>
#include <sys/socket.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <random>
#include <thread>

#include "course/player/page.h"
#endif

namespace course {

#ifdef COURSE_HAS_HTTPLIB

namespace {

/// How long a browser that asks for news is left to wait for them.
constexpr std::chrono::seconds news_patience{20};
/// Each page that is open holds one.
constexpr std::size_t threads = 16;

/// 128 bits that nobody can guess.
std::string new_secret() {
    std::random_device source;
    std::string text;
    for (int k = 0; k < 4; ++k) text += fmt::format("{:08x}", source());
    return text;
}

/// Around the page: it alone may ask this server for something.
std::string frame_page() {
    return make_page({.title = "Live",
                      .styles = {"base.css", "live.css"},
                      .body = "live.html",
                      .scripts = {"svg.js", "stepper.js", "live.js"},
                      .data = "null",
                      .policy = "connect-src 'self'; frame-src 'self'"});
}

void refuse(httplib::Response& response, int status, const char* why) {
    response.status = status;
    response.set_content(std::string(why) + "\n", "text/plain");
}

}  // namespace

class PageServer::Inside {
public:
    explicit Inside(int port);
    ~Inside();
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;

    int port() const { return port_; }
    std::string root() const { return "/" + secret_ + "/"; }
    void tell(std::string* page, std::string problem);

private:
    void listen(int port);
    void answer(const httplib::Request& request, httplib::Response& response);
    void answer_with_news(const httplib::Request& request,
                          httplib::Response& response);

    const std::string secret_ = new_secret();
    const std::string frame_ = frame_page();
    int port_ = 0;

    std::mutex mutex_;  ///< for all from here to told_
    int version_ = 0;   ///< of all that is told
    int page_number_ = 0;
    std::string page_;
    std::string problem_ = "The page is being made ...";
    bool ending_ = false;
    std::condition_variable told_;

    httplib::Server server_;
    std::thread thread_;
};

PageServer::Inside::Inside(int port) {
    server_.new_task_queue = [] { return new httplib::ThreadPool(threads); };
    server_.set_keep_alive_max_count(1);
    server_.set_read_timeout(5);
    server_.set_write_timeout(5);
    server_.set_payload_max_length(0);
    // The library's own choice lets two servers have the same port.
    server_.set_socket_options([](socket_t socket) {
        const int yes = 1;
        ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server_.set_default_headers(
        {{"Cache-Control", "no-store"},
         {"Content-Security-Policy", "frame-ancestors 'self'"},
         {"Cross-Origin-Resource-Policy", "same-origin"},
         {"Referrer-Policy", "no-referrer"},
         {"X-Content-Type-Options", "nosniff"}});
    server_.set_pre_routing_handler(
        [this](const httplib::Request& request, httplib::Response& response) {
            answer(request, response);
            return httplib::Server::HandlerResponse::Handled;
        });
    listen(port);
}

void PageServer::Inside::listen(int port) {
    const char* here = "127.0.0.1";
    port_ = port;
    if (port == 0)
        port_ = server_.bind_to_any_port(here);
    else if (!server_.bind_to_port(here, port))
        port_ = -1;
    if (port_ < 0)
        throw CannotServe(
            fmt::format("port {} of this machine cannot be had: is something "
                        "else there? Without --port a free one is taken",
                        port));
    thread_ = std::thread([this] { server_.listen_after_bind(); });
    while (!server_.is_running())
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

PageServer::Inside::~Inside() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    told_.notify_all();
    server_.stop();
    thread_.join();
}

void PageServer::Inside::tell(std::string* page, std::string problem) {
    {
        const std::lock_guard lock(mutex_);
        ++version_;
        problem_ = std::move(problem);
        if (page) {
            ++page_number_;
            page_ = std::move(*page);
        }
    }
    told_.notify_all();
}

void PageServer::Inside::answer(const httplib::Request& request,
                                httplib::Response& response) {
    if (request.get_header_value("Host") != fmt::format("127.0.0.1:{}", port_))
        return refuse(response, 403, "this server is 127.0.0.1 only");
    if (request.path.rfind(root(), 0) != 0)
        return refuse(response, 403, "the address lacks its secret");
    if (request.method != "GET")
        return refuse(response, 405, "this server is asked with GET only");
    const std::string what = request.path.substr(root().size());
    if (what.empty())
        return response.set_content(frame_, "text/html; charset=utf-8");
    if (what == "news") return answer_with_news(request, response);
    if (what != "page") return refuse(response, 404, "there is nothing");
    const std::lock_guard lock(mutex_);
    response.set_content(page_, "text/html; charset=utf-8");
}

/// Waits until there is more than the asker knows, who gives the version.
void PageServer::Inside::answer_with_news(const httplib::Request& request,
                                          httplib::Response& response) {
    const std::string known = request.get_param_value("after");
    std::unique_lock lock(mutex_);
    told_.wait_for(lock, news_patience, [&] {
        return ending_ || std::to_string(version_) != known;
    });
    response.set_header("Version", std::to_string(version_));
    response.set_header("Page", std::to_string(page_number_));
    response.set_content(problem_, "text/plain; charset=utf-8");
}

PageServer::PageServer(int port) : inside_(std::make_unique<Inside>(port)) {}

int PageServer::port() const {
    return inside_->port();
}

std::string PageServer::address() const {
    return fmt::format("http://127.0.0.1:{}{}", port(), inside_->root());
}

void PageServer::show(std::string page) {
    inside_->tell(&page, "");
}

void PageServer::complain(std::string sentence) {
    inside_->tell(nullptr, std::move(sentence));
}

#else

class PageServer::Inside {};

PageServer::PageServer(int /*port*/) {
    throw CannotServe(
        "live mode needs cpp-httplib, which was not there when this program "
        "was built. Install it (Debian, Ubuntu: libcpp-httplib-dev; Fedora: "
        "cpp-httplib-devel; Arch, Homebrew: cpp-httplib), remove the folder "
        ".build and try again");
}
int PageServer::port() const {
    return 0;
}
std::string PageServer::address() const {
    return "";
}
void PageServer::show(std::string /*page*/) {}
void PageServer::complain(std::string /*sentence*/) {}

#endif

PageServer::~PageServer() = default;

}  // namespace course
