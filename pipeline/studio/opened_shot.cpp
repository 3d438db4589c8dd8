#include "pipeline/studio/opened_shot.h"

#include <algorithm>
#include <utility>

#include "pipeline/store/cache_folder.h"

namespace carom::studio {

void OpenedShot::open_journal(const std::string& cache_folder) {
    const std::string cache =
        cache_folder.empty() ? pipeline::default_cache_folder() : cache_folder;
    journal_ =
        std::make_unique<Journal>(files_.shot(), JournalOptions{.folder = cache + "/studio"});
    recovered_ = files_.recoverable(journal_->found());
    unreachable_ = files_.unreachable(journal_->found());
    keep_unsaved();
}

bool OpenedShot::recover(bool use) {
    const std::vector<RecoveredText> texts = std::exchange(recovered_, {});
    return use && files_.recover(texts);
}

void OpenedShot::keep_unsaved() {
    std::vector<RecoveredText> texts = files_.unsaved();
    for (const auto* others : {&recovered_, &unreachable_}) {
        for (const RecoveredText& one : *others) {
            if (std::ranges::find(texts, one.file, &RecoveredText::file) == texts.end()) {
                texts.push_back(one);
            }
        }
    }
    journal_->keep(std::move(texts));
}

std::vector<RecoveredText> OpenedShot::unsaved_of_others() const {
    std::vector<RecoveredText> texts = files_.unsaved();
    std::erase_if(texts, [&](const RecoveredText& one) { return one.file == files_.shot(); });
    return texts;
}

void OpenedShot::keep_undecided() {
    std::vector<RecoveredText> texts = recovered_;
    texts.insert(texts.end(), unreachable_.begin(), unreachable_.end());
    journal_->keep(std::move(texts));
}

}  // namespace carom::studio
