// Reads the elements of a scene text one after the other.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/import/attributes.h"
#include "pipeline/import/scene_model.h"
#include "pipeline/import/tokenizer.h"

namespace carom::pipeline::scene_text {

class SceneReader {
  public:
    explicit SceneReader(config::ProblemList& problems) : problems_(problems) {}

    [[nodiscard]] SceneModel read(const std::vector<Item>& items);

  private:
    struct Element {
        const char* type;
        void (SceneReader::*read)(const Name&, const Item&);
    };
    static const std::vector<Element>& elements();
    /// `words`: the words before the block.
    void element(const std::vector<Item>& words, const Item& block);

    /// "sphere 'First'"
    [[nodiscard]] static std::string owner(const char* type, const Name& name);
    [[nodiscard]] Attributes attributes(const char* type, const Name& name) {
        return {owner(type, name), problems_};
    }

    /// Registers the name of element `index`. A name must be unique within its space.
    void claim(const char* space, const Name& name, std::size_t index);
    /// The index of the earlier element with the name `given`; empty if there is no name, or after
    /// a problem.
    [[nodiscard]] std::optional<std::size_t> refer(const char* space,
                                                   const std::optional<Name>& given);

    void settings(const Name& name, const Item& block);
    void camera(const Name& name, const Item& block);
    void phong_info(const Name& name, const Item& block);
    void texture(const Name& name, const Item& block);
    void material_phong(const Name& name, const Item& block);
    void material_texture(const Name& name, const Item& block);
    void plane(const Name& name, const Item& block);
    void sphere(const Name& name, const Item& block);
    void triangle(const Name& name, const Item& block);
    void rectangle(const Name& name, const Item& block);
    void box(const Name& name, const Item& block);
    void light_point(const Name& name, const Item& block);
    void light_rect(const Name& name, const Item& block);
    void light_bulb(const Name& name, const Item& block);

    void add_object(Object object, const std::optional<Name>& material, Real physics);
    void add_light(Light light);
    [[nodiscard]] ForceEvent force_event(const std::string& owner, const Item& block);

    struct Known {
        config::Place place;
        std::size_t index = 0;
    };
    config::ProblemList& problems_;
    SceneModel model_;
    std::map<std::pair<std::string, std::string>, Known> names_;  // by space and name
};

}  // namespace carom::pipeline::scene_text
