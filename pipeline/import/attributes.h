// Reads the attributes in an element's braces and stores them in the fields of a table.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/config/problem_list.h"
#include "pipeline/import/scene_model.h"
#include "pipeline/import/tokenizer.h"

namespace carom::pipeline::scene_text {

/// The values that a number may have.
struct Limits {
    double low = -1e9;
    double high = 1e9;
    bool is_whole = false;
    bool above_low = false;       // `low` itself is not allowed
    bool can_be_default = false;  // -1 means the default: the field stays empty
};

/// The attributes of one element. The fields must outlive the table.
class Attributes {
  public:
    /// `owner`: "sphere 'First'", for messages.
    Attributes(std::string owner, config::ProblemList& problems)
        : owner_(std::move(owner)), problems_(&problems) {}

    Attributes& real(std::string name, Real& field, Limits limits = {});
    Attributes& vector(std::string name, std::optional<Vec3>& field);
    /// An attribute that may be repeated.
    Attributes& points(std::string name, std::vector<Vec3>& field);
    Attributes& word(std::string name, std::optional<Name>& field);
    /// A nested block, which may be repeated.
    Attributes& blocks(std::string name, std::function<void(const Item&)> read);

    /// Adds another spelling of the attribute that was added last.
    Attributes& also(std::string spelling);
    /// Makes the attribute that was added last mandatory.
    Attributes& required();

    /// Reads all `items` and reports problems. `place` is the position of the element.
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

/// The value of a finite decimal number; empty for any other text.
[[nodiscard]] std::optional<double> to_number(const std::string& word);

}  // namespace carom::pipeline::scene_text
