// SPDX-License-Identifier: MIT
#pragma once

#include <mutex>
#include <petscsys.h>
#include <string>

/// The engines' access to PETSc; not installed.
namespace polydec::petsc {

/// Exclusive use of PETSc by one thread, with errors recorded instead of printed. Sessions of one
/// thread may nest: an eigensolver may call a linear solver of PETSc.
class Session {
public:
    /// Starts PETSc, and MPI below it, unless they are running; they then end at program exit.
    /// Reads no command line and no option files, and leaves no signal handler. engine: named in
    /// errors. Throws BackendUnavailable if PETSc or MPI cannot be started, or has already ended.
    explicit Session(std::string engine);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// If `error` is one, throws SolverFailure with the engine, the attempted action and PETSc's
    /// reason.
    void require(PetscErrorCode error, const char* what) const;

private:
    static PetscErrorCode record(MPI_Comm, int, const char*, const char*, PetscErrorCode,
                                 PetscErrorType type, const char* message, void* session);

    std::string engine_;
    std::lock_guard<std::recursive_mutex> lock_;
    std::string reason_;
};

/// Whether PETSc objects are usable: false before the first session and after its end.
bool is_running();

/// Owns a PETSc object, such as Owned<KSP, KSPDestroy>. Objects that outlive PETSc, such as those
/// in static variables, are not destroyed. Destroy within a session.
template <typename Object, PetscErrorCode (*destroy)(Object*)>
class Owned {
public:
    Owned() = default;
    ~Owned() { reset(); }
    Owned(const Owned&) = delete;
    Owned& operator=(const Owned&) = delete;

    Object get() const { return object_; }

    /// The address where a PETSc function stores a new object.
    Object* put() {
        reset();
        return &object_;
    }

    void reset() {
        if (object_ && is_running())
            destroy(&object_);
        object_ = nullptr;
    }

private:
    Object object_ = nullptr;
};

} // namespace polydec::petsc
