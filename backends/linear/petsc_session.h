// SPDX-License-Identifier: MIT
#pragma once

#include <mutex>
#include <petscsys.h>
#include <string>

/// The use of PETSc by the engines; installed nowhere.
namespace polydec::petsc {

/// PETSc for one thread at a time, with its errors recorded instead of printed. Sessions of one
/// thread may nest: an eigensolver calls what may be a linear solver of PETSc.
class Session {
public:
    /// Starts PETSc, and MPI below it, where nobody has; what was started here is ended when the
    /// program exits. No command line and no file of options is read, and no signal handler stays
    /// behind. engine: named in errors. Throws BackendUnavailable if PETSc or MPI cannot be
    /// started, or has been ended already.
    explicit Session(std::string engine);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Throws SolverFailure with the engine, what was tried and PETSc's reason where `error` is
    /// one.
    void require(PetscErrorCode error, const char* what) const;

private:
    static PetscErrorCode record(MPI_Comm, int, const char*, const char*, PetscErrorCode,
                                 PetscErrorType type, const char* message, void* session);

    std::string engine_;
    std::lock_guard<std::recursive_mutex> lock_;
    std::string reason_;
};

/// Whether objects of PETSc can be used: false before the first session and after its end.
bool is_running();

/// Has `end` called when the program exits, before PETSc ends if it was started here.
void at_exit(void (*end)());

/// Owns an object of PETSc, such as Owned<KSP, KSPDestroy>. Objects that outlive PETSc, as those in
/// static variables may, are left to the end of the program. Destroyed within a session.
template <typename Object, PetscErrorCode (*destroy)(Object*)>
class Owned {
public:
    Owned() = default;
    ~Owned() { reset(); }
    Owned(const Owned&) = delete;
    Owned& operator=(const Owned&) = delete;

    Object get() const { return object_; }

    /// Where a function of PETSc puts a new object.
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
