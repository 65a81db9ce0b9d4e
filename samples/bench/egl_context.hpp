// SPDX-License-Identifier: MIT
// An OpenGL context as a host of Nicol's has one, by EGL without a surface.
#pragma once

/// Core context of OpenGL 4.5, current on the thread that made it until its end.
class EglContext {
public:
    /// Throws Failure if EGL has no such context.
    EglContext();
    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    /// Returns the address of an OpenGL function.
    [[nodiscard]] void* function(const char* name) const;
    /// Returns whether this context is current on the calling thread.
    [[nodiscard]] bool is_current() const;

private:
    struct Egl;
    const Egl& egl_;
    void* context_ = nullptr;
};
