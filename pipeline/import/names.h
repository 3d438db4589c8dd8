// Names of a scene text in the form that YAML names have: letters without accents, digits, '_',
// '-'.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace carom::pipeline::scene_text {

/// The UTF-8 text of a scene. A text that is not UTF-8 is taken for Windows-1250, in which Czech
/// programs wrote; `was_decoded` then becomes true. A byte order mark is left out.
[[nodiscard]] std::string as_utf8(const std::string& text, bool& was_decoded);

/// The UTF-8 `name` with its Latin letters freed from accents ("kůže" is "kuze"); other letters
/// stay.
[[nodiscard]] std::string without_accents(const std::string& name);

/// Valid and different names for the things of one kind.
class Names {
  public:
    /// `given`: all names of the kind. Those that are valid are never given to another thing.
    explicit Names(const std::vector<std::string>& given = {});

    /// `name` itself if it is one of the valid given ones, otherwise a name derived from it.
    [[nodiscard]] std::string claim(const std::string& name);

  private:
    std::set<std::string> kept_, taken_;
    std::map<std::string, int> latest_;  // number given to a name that was taken
};

}  // namespace carom::pipeline::scene_text
