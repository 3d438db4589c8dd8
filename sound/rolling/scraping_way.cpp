#include "sound/rolling/scraping_way.h"

#include "sound/rolling/rolling_level.h"

namespace carom::sound {
namespace {

double middle_of(const Scrape& scrape) {
    return scrape.from + (scrape.to - scrape.from) / 2;
}

void add_piece(double from, double to, const Scrape& first, const Scrape& last, Way& way) {
    if (to > from) {
        way.add(
            from, to - from, {first.slip, (first.slip + last.slip) / 2, last.slip},
            {scraping_pressure(first.slip, first.force), scraping_pressure(last.slip, last.force)});
    }
}

}  // namespace

Way scraping_way(std::span<const Scrape> scrapes) {
    Way way;
    if (scrapes.empty()) {
        return way;
    }
    add_piece(scrapes.front().from, middle_of(scrapes.front()), scrapes.front(), scrapes.front(),
              way);
    for (std::size_t i = 1; i < scrapes.size(); ++i) {
        add_piece(middle_of(scrapes[i - 1]), middle_of(scrapes[i]), scrapes[i - 1], scrapes[i],
                  way);
    }
    add_piece(middle_of(scrapes.back()), scrapes.back().to, scrapes.back(), scrapes.back(), way);
    return way;
}

}  // namespace carom::sound
