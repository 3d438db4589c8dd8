// Scratch memory of an integrator, handed from one thread to the next.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "render/integrator/integrator.h"

namespace carom::render {

/// Keeps what was returned, since making it takes as long as tracing some hundred rays. Any thread
/// may call.
class WorkspacePool {
  public:
    /// The integrator is borrowed.
    explicit WorkspacePool(const Integrator& integrator) : integrator_(integrator) {}

    /// A workspace until the object is destroyed; the pool must live longer.
    class Loan {
      public:
        explicit Loan(WorkspacePool& pool) : pool_(pool), workspace_(pool.take()) {}
        ~Loan() { pool_.give(std::move(workspace_)); }
        Loan(const Loan&) = delete;
        Loan& operator=(const Loan&) = delete;

        /// Null if the integrator needs none.
        [[nodiscard]] Integrator::Workspace* get() const { return workspace_.get(); }

      private:
        WorkspacePool& pool_;
        std::unique_ptr<Integrator::Workspace> workspace_;
    };

  private:
    [[nodiscard]] std::unique_ptr<Integrator::Workspace> take() {
        {
            const std::lock_guard lock(mutex_);
            if (!free_.empty()) {
                auto workspace = std::move(free_.back());
                free_.pop_back();
                return workspace;
            }
        }
        return integrator_.make_workspace();
    }
    void give(std::unique_ptr<Integrator::Workspace> workspace) {
        if (workspace) {
            const std::lock_guard lock(mutex_);
            free_.push_back(std::move(workspace));
        }
    }

    const Integrator& integrator_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<Integrator::Workspace>> free_;
};

}  // namespace carom::render
