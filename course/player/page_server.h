// Serves one page that changes, to browsers on this machine only.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

namespace course {

/// Thrown when there can be no server: the port is taken, or this program was
/// built without cpp-httplib; says what to do.
struct CannotServe : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Listens on 127.0.0.1 while it lives. It knows three things, for GET only,
/// below a secret that is in its address: the frame around the page, the page,
/// and what has become of it. Pages of other places know neither the secret nor
/// get past the check of Host, which stops names that lead here: all else is
/// 403, 404 or 405. Nothing that is sent to it has any other effect.
class PageServer {
public:
    /// Port 0: the system chooses. Throws CannotServe.
    explicit PageServer(int port);
    ~PageServer();
    PageServer(const PageServer&) = delete;
    PageServer& operator=(const PageServer&) = delete;

    int port() const;

    /// "http://127.0.0.1:40123/<secret>/", for a browser.
    std::string address() const;

    /// Shows this page from now on, at the step where the one before stood.
    void show(std::string page);

    /// Leaves the page as it is and says this sentence below it, until the next
    /// page is shown.
    void complain(std::string sentence);

private:
    class Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace course
