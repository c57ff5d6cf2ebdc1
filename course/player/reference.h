// Calls the reference of an exercise as a submission is called: compiled, and
// run in a process of its own. The pictures of the notes are made so from what
// the code of the lecture really does.
#pragma once

#include <memory>
#include <string>
#include <type_traits>

#include "course/runner/client.h"
#include "course/runner/process.h"
#include "course/runner/temporary_folder.h"

namespace course {

/// The worker that has loaded the reference of one exercise.
class ReferenceWorker {
public:
    /// Compiles it: about a second. Precondition: has_solutions(). Throws
    /// UnknownExercise, and SystemError with what the compiler said.
    explicit ReferenceWorker(const std::string& exercise);
    ~ReferenceWorker();
    ReferenceWorker(const ReferenceWorker&) = delete;
    ReferenceWorker& operator=(const ReferenceWorker&) = delete;

    /// The bytes of the result. Throws SystemError when the process failed, and
    /// what the function threw.
    std::string call(const std::function<void(Client&, Request&)>& add);

private:
    std::string name_;
    TemporaryFolder folder_;
    Descriptor complaints_;
    std::unique_ptr<Process> launcher_;
    std::unique_ptr<Client> client_;
    std::string failure_;
};

/// The function of an exercise, by the type that its contract gives to it:
///     const Reference<decltype(smooth)> smooth_by_reference("smooth");
template <class Function>
class Reference;

template <class R, class... P>
class Reference<R(P...)> {
public:
    explicit Reference(const std::string& exercise)
        : worker_(std::make_unique<ReferenceWorker>(exercise)) {}

    /// Throws as ReferenceWorker::call, and CodecError.
    R operator()(const std::remove_cvref_t<P>&... arguments) const {
        return decode<R>(worker_->call([&](Client& client, Request& request) {
            (add_argument(client, request, arguments), ...);
        }));
    }

private:
    std::unique_ptr<ReferenceWorker> worker_;
};

}  // namespace course
