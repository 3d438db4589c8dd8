// Reads the attributes between an element's braces into the fields that a table names.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/config/problem_list.h"
#include "pipeline/import/scene_model.h"
#include "pipeline/import/tokenizer.h"

namespace carom::pipeline::scene_text {

/// What a number may be.
struct Limits {
    double low = -1e9;
    double high = 1e9;
    bool is_whole = false;
    bool above_low = false;       // `low` itself is not allowed
    bool can_be_default = false;  // -1 asks for the default, and leaves the field empty
};

/// The attributes of one element. The fields must outlive the table.
class Attributes {
  public:
    /// `owner`: "sphere 'First'", for messages.
    Attributes(std::string owner, config::ProblemList& problems)
        : owner_(std::move(owner)), problems_(&problems) {}

    Attributes& real(std::string name, Real& field, Limits limits = {});
    Attributes& vector(std::string name, std::optional<Vec3>& field);
    /// May stand there several times.
    Attributes& points(std::string name, std::vector<Vec3>& field);
    Attributes& word(std::string name, std::optional<Name>& field);
    /// A nested block, which may stand there several times.
    Attributes& blocks(std::string name, std::function<void(const Item&)> read);

    /// Another spelling of the attribute named last.
    Attributes& also(std::string spelling);
    /// The attribute named last must be there.
    Attributes& required();

    /// Reads all of `items`; what is wrong becomes problems, `place` is the element's own.
    void read(const std::vector<Item>& items, const config::Place& place);

  private:
    enum class Kind { real, vector, word, block };
    struct Attribute {
        std::vector<std::string> spellings;
        Kind kind = Kind::real;
        bool repeats = false;
        bool is_required = false;
        Limits limits{};
        std::function<void(double)> store_real{};
        std::function<void(const Vec3&)> store_vector{};
        std::function<void(const Item&)> store_item{};
        int count = 0;
    };
    [[nodiscard]] Attribute* find(const std::string& word);
    void value(Attribute& attribute, const Item& name, const Item& value);
    void number(Attribute& attribute, const Item& name, const Item& value);
    void triple(Attribute& attribute, const Item& name, const Item& value);
    std::size_t unknown(const std::vector<Item>& items, std::size_t at);

    std::string owner_;
    config::ProblemList* problems_;
    std::vector<Attribute> table_;
};

/// A decimal number; empty for anything else, not finite ones included.
[[nodiscard]] std::optional<double> to_number(const std::string& word);

}  // namespace carom::pipeline::scene_text
