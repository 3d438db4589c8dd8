// A plugin of clang-tidy 14 that takes system headers out of what its checks walk through. Findings
// there are not printed anyway, and a source of carom has a hundred times as many declarations in
// them as of its own.

#include <vector>

#include <clang-tidy/ClangTidyCheck.h>
#include <clang-tidy/ClangTidyModule.h>
#include <clang-tidy/ClangTidyModuleRegistry.h>
#include <clang/AST/ASTContext.h>
#include <clang/ASTMatchers/ASTMatchFinder.h>

namespace {

using clang::ast_matchers::MatchFinder;

// Matches the whole file, which is what a walk comes to first, and names the declarations that the
// rest of the walk is about.
class SkipSystemHeaders : public clang::tidy::ClangTidyCheck {
  public:
    using ClangTidyCheck::ClangTidyCheck;

    void registerMatchers(MatchFinder* finder) override {
        finder->addMatcher(clang::ast_matchers::translationUnitDecl().bind("file"), this);
    }

    void check(const MatchFinder::MatchResult& found) override {
        std::vector<clang::Decl*> own;
        for (clang::Decl* declaration : found.Context->getTranslationUnitDecl()->decls()) {
            if (!found.SourceManager->isInSystemHeader(declaration->getLocation())) {
                own.push_back(declaration);
            }
        }
        found.Context->setTraversalScope(own);
    }
};

class Module : public clang::tidy::ClangTidyModule {
  public:
    void addCheckFactories(clang::tidy::ClangTidyCheckFactories& factories) override {
        factories.registerCheck<SkipSystemHeaders>("carom-skip-system-headers");
    }
};

}  // namespace

static clang::tidy::ClangTidyModuleRegistry::Add<Module> registered("carom",
                                                                    "what scripts/tidy needs");
