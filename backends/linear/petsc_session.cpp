// SPDX-License-Identifier: MIT
#include "backends/linear/petsc_session.h"

#include "system/memory.h"

#include <fmt/format.h>

#include <csignal>
#include <cstdlib>
#include <map>

namespace polydec::petsc {

namespace {

// PETSc is not made for threads, not even with objects of their own.
std::recursive_mutex mutex;

bool mpi_has_ended() {
    int ended = 0;
    MPI_Finalized(&ended);
    return ended != 0;
}

// MPI leaves handlers behind for the signals of crashes; the program's own are put back.
class KeptSignals {
public:
    KeptSignals() {
        for (int signal = 1; signal < NSIG; ++signal) {
            struct sigaction action {};
            if (sigaction(signal, nullptr, &action) == 0)
                actions_[signal] = action;
        }
    }
    ~KeptSignals() {
        for (const auto& [signal, action] : actions_)
            sigaction(signal, &action, nullptr);
    }
    KeptSignals(const KeptSignals&) = delete;
    KeptSignals& operator=(const KeptSignals&) = delete;

private:
    std::map<int, struct sigaction> actions_;
};

void end_petsc() {
    if (is_running())
        PetscFinalize();
}

// These two options say what PETSc does when it starts; nothing of them is left afterwards.
PetscErrorCode start_petsc() {
    const KeptSignals signals;
    const char* const quiet[] = {"-no_signal_handler", "-skip_petscrc"};
    for (const char* option : quiet)
        if (const auto error = PetscOptionsSetValue(nullptr, option, "true"))
            return error;

    PETSC_MPI_THREAD_REQUIRED = MPI_THREAD_SERIALIZED;
    if (const auto error = PetscInitialize(nullptr, nullptr, nullptr, nullptr))
        return error;
    for (const char* option : quiet)
        PetscOptionsClearValue(nullptr, option);
    return PetscErrorCode{};
}

void start(const std::string& engine) {
    if (PetscFinalizeCalled || mpi_has_ended())
        throw BackendUnavailable(
            engine + ": this program has finalized PETSc or MPI, which cannot start again\n"
                     "Finalize them after the last solver is destroyed.");
    if (PetscInitializeCalled)
        return;
    if (const auto error = start_petsc())
        throw BackendUnavailable(
            fmt::format("{}: PETSc cannot start: PETSc error {}", engine, static_cast<int>(error)));
    static_cast<void>(std::atexit(end_petsc)); // else the system ends it
}

} // namespace

bool is_running() {
    return PetscInitializeCalled && !PetscFinalizeCalled && !mpi_has_ended();
}

Session::Session(std::string engine) : engine_(std::move(engine)), lock_(mutex) {
    start(engine_);
    PetscPushErrorHandler(record, this);
}

Session::~Session() {
    if (is_running())
        PetscPopErrorHandler();
}

PetscErrorCode Session::record(MPI_Comm, int, const char*, const char*, PetscErrorCode error,
                               PetscErrorType type, const char* message, void* session) {
    // An error is reported again by each function that it passes through; the first one knows why.
    if (type == PETSC_ERROR_INITIAL && message)
        static_cast<Session*>(session)->reason_ = message;
    return error;
}

void Session::require(PetscErrorCode error, const char* what) const {
    if (!error)
        return;
    std::string reason = reason_;
    if (const char* text = nullptr; reason.empty()) {
        PetscErrorMessage(error, &text, nullptr);
        reason = text ? text : fmt::format("error {}", static_cast<int>(error));
    }
    const auto message = fmt::format("{}: {} failed in PETSc: {}", engine_, what, reason);
    if (error == PETSC_ERR_MEM)
        throw OutOfMemory(message, SolveReport::failed(engine_));
    throw SolverFailure(message, SolveReport::failed(engine_));
}

} // namespace polydec::petsc
