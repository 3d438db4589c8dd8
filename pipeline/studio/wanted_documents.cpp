#include "pipeline/studio/wanted_documents.h"

#include "core/error.h"

namespace carom::studio {

void WantedDocuments::add(const AskedDocument& asked, bool writes) {
    const std::lock_guard lock(mutex_);
    wanted_.insert(asked);
    if (writes) {
        exports_.insert(asked);
    }
}

void WantedDocuments::remove(const AskedDocument& asked) {
    const std::lock_guard lock(mutex_);
    wanted_.erase(asked);
    exports_.erase(asked);
}

void WantedDocuments::stop(const AskedDocument& asked) {
    const std::lock_guard lock(mutex_);
    wanted_.erase(asked);
    if (child_ != nullptr && child_asked_ == asked) {
        child_->interrupt();
    }
}

void WantedDocuments::closed(PageId page) {
    const std::lock_guard lock(mutex_);
    std::erase_if(wanted_, [&](const AskedDocument& asked) {
        return asked.first == page && !exports_.contains(asked);
    });
    if (child_ != nullptr && child_asked_.first == page && !wanted_.contains(child_asked_)) {
        child_->interrupt();
    }
}

void WantedDocuments::end() {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
    if (child_ != nullptr) {
        child_->interrupt();
    }
}

void WantedDocuments::require(const AskedDocument& asked) {
    const std::lock_guard lock(mutex_);
    if (!is_wanted(asked)) {
        throw Error("it was stopped");
    }
}

/// With the mutex.
bool WantedDocuments::is_wanted(const AskedDocument& asked) const {
    return !is_ending_ && wanted_.contains(asked);
}

WantedDocuments::Running::Running(WantedDocuments& wanted, const AskedDocument& asked,
                                  ChildProgram& child)
    : wanted_(wanted) {
    const std::lock_guard lock(wanted_.mutex_);
    wanted_.child_ = &child;
    wanted_.child_asked_ = asked;
    if (!wanted_.is_wanted(asked)) {
        child.interrupt();
    }
}

WantedDocuments::Running::~Running() {
    const std::lock_guard lock(wanted_.mutex_);
    wanted_.child_ = nullptr;
}

}  // namespace carom::studio
