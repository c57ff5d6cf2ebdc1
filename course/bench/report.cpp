// Tables of ratios.
#include "course/bench/report.h"

#include <fmt/format.h>

#include <algorithm>

namespace bench {

void Results::expect(const std::string& what) {
    if (std::find(order_.begin(), order_.end(), what) == order_.end())
        order_.push_back(what);
}

void Results::add(const std::string& what, const std::string& who,
                  double value) {
    const auto [place, is_new] = values_.try_emplace({what, who}, value);
    if (!is_new) place->second = std::min(place->second, value);
}

std::string Results::table(const std::vector<std::string>& who, double scale,
                           const char* unit) const {
    std::string text = fmt::format("  {:<28}{:>16}", "", who.front());
    for (std::size_t k = 1; k < who.size(); ++k)
        text += fmt::format("{:>12}", "/ " + who[k]);
    text += '\n';
    for (const std::string& what : order_) {
        const auto own = values_.find({what, who.front()});
        if (own == values_.end()) continue;
        text += fmt::format("  {:<28}{:>10.2f} {:<5}", what,
                            own->second * scale, unit);
        for (std::size_t k = 1; k < who.size(); ++k) {
            const auto other = values_.find({what, who[k]});
            text += other == values_.end()
                        ? fmt::format("{:>12}", "-")
                        : fmt::format("{:>12.3f}", own->second / other->second);
        }
        text += '\n';
    }
    return text;
}

}  // namespace bench
