// Lists of names in options.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"

namespace carom::pipeline {

/// The members of a set that are named in a list: "all", or names with commas between them, without
/// repetition. `what`: "kernel"; `name_of`: the name of a member. Throws Error that names the
/// mistake and lists the names.
template <class Member, class NameOf>
std::vector<Member> named_in(const std::string& text, const std::string& what,
                             std::span<const Member> all, const NameOf& name_of) {
    if (text == "all") {
        return {all.begin(), all.end()};
    }
    std::vector<Member> chosen;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string given = text.substr(begin, end - begin);
        const auto found = std::ranges::find(all, given, name_of);
        if (found == all.end()) {
            std::string names;
            for (const Member member : all) {
                names += std::string(name_of(member)) + ", ";
            }
            throw Error("unknown " + what + " '" + given + "'; use one of " + names + "or all");
        }
        if (std::ranges::find(chosen, *found) != chosen.end()) {
            throw Error("the " + what + " '" + given + "' is named twice");
        }
        chosen.push_back(*found);
        begin = end + 1;
    }
    return chosen;
}

}  // namespace carom::pipeline
