#include "base/error.hpp"
#include "sequence/budget.hpp"
#include "worlds.hpp"

#include <gtest/gtest.h>

namespace filum::sequence {
namespace {

Index ended(const SequenceResult& r, Cause c) { return tally(r.ends)[static_cast<std::size_t>(c)]; }

std::vector<polygon::Region> towers_apart(double gap) {
    std::vector<Outlined> two;
    for (std::uint32_t l = 0; l < 100; ++l) {
        two.push_back({l, box(0, 0, 5, 5)});
        two.push_back({l, box(5 + gap, 0, 5, 5)});
    }
    return world(two);
}

TEST(Ends, NameThePartOfTheHead) {
    const auto causes = [](double gap, machine::Head head) {
        Options o;
        o.heads = head;
        const SequenceResult r = sequence(towers_apart(gap), o);
        EXPECT_EQ(r.ends.size(), r.stroke.back() + 1);
        EXPECT_EQ(ended(r, Cause::top), 2);
        for (const End& e : r.ends) EXPECT_NEAR(e.distance, e.cause == Cause::top ? 0 : gap, 1e-9);
        return tally(r.ends);
    };
    const auto of = [](const std::vector<Index>& t, Cause c) { return t[static_cast<std::size_t>(c)]; };
    EXPECT_EQ(of(causes(0.15, {}), Cause::tip),
              99); // the flat reaches 0.2 mm: the other is waited for after every layer
    EXPECT_EQ(of(causes(1, {}), Cause::cone), 14);
    EXPECT_EQ(of(causes(10, {}), Cause::carriage), 2);
    machine::Head low;
    low.gantry_height = 10;
    EXPECT_EQ(of(causes(30, low), Cause::gantry), 1);
    EXPECT_EQ(of(causes(30, {}), Cause::top), 2);
}

TEST(Ends, OfStrokesThatMeetOrRestOnTwo) {
    // two legs under a bar: one leg's stroke goes on into it
    const SequenceResult arch =
        sequence(world({{0, box(0, 0, 1, 1)}, {0, box(9, 0, 1, 1)}, {1, box(0, 0, 10, 1)}}), {});
    EXPECT_EQ(ended(arch, Cause::top), 1);
    EXPECT_EQ(ended(arch, Cause::taken), 1);
    // layer by layer no stroke waits for anything
    Options layers;
    layers.by_layers = true;
    const SequenceResult l = sequence(towers_apart(10), layers);
    EXPECT_EQ(ended(l, Cause::top), 2);
    EXPECT_EQ(ended(l, Cause::open), 99);
    // b's stroke could go on to c, which also rests on d, and d on a by no link: d starts anew and c after it
    auto rest = world({{0, box(0, 0, 2, 2)}, {0, box(4, 0, 2, 2)}, {1, box(0, 0, 6, 2)}});
    rest[2].below[0].link = rest[2].below[1].link = true;
    Options none;
    none.heads.common.none = true;
    EXPECT_EQ(ended(sequence(rest, none), Cause::taken), 1);
    rest[2].below[1].link = false; // the second leg must be waited for, and leads nowhere
    const SequenceResult r = sequence(rest, none);
    EXPECT_EQ(ended(r, Cause::top), 2);
    // by hand: the first leg, the second, the bar; only the second keeps the first from going on
    const Graph g = support_graph(rest);
    const std::vector<Index> order{0, 1, 2};
    const auto by_hand = ends(g, order, g.after, {}, none.heads);
    ASSERT_EQ(by_hand.size(), 3);
    EXPECT_EQ(by_hand[0].cause, Cause::support);
    EXPECT_EQ(by_hand[0].ahead, 2);
    EXPECT_EQ(by_hand[0].awaited, 1);
    EXPECT_EQ(by_hand[1].cause, Cause::top);
}

// What an end names is a precedence that the order had to keep: the head over the awaited one touches the one ahead.
TEST(Ends, AreBindingInRandomWorlds) {
    Random random(10);
    Index by_head = 0;
    for (int trial = 0; trial < 20; ++trial) {
        const auto regions = random_world(random, 40, 4, uniform(random, 3, 8));
        Options o;
        o.heads.common.cone_angle = 2;
        o.budget = 1'000'000;
        const SequenceResult r = sequence(regions, o);
        std::vector<Index> place(regions.size());
        for (Index i = 0; i < r.order.size(); ++i) place[r.order[i]] = i;
        Index sum = 0;
        for (const Index count : tally(r.ends)) sum += count;
        EXPECT_EQ(sum, r.stroke.back() + 1);
        for (const End& e : r.ends) {
            if (e.awaited == kNone) continue;
            EXPECT_TRUE(place[e.region] < place[e.awaited] && place[e.awaited] < place[e.ahead]);
            if (e.cause < Cause::tip || e.cause > Cause::gantry) continue;
            ++by_head;
            machine::Head larger = o.heads.common;
            larger.flat_radius += 1e-3;
            larger.carriage_x += 0.1;
            larger.carriage_y += 0.1;
            EXPECT_TRUE(plainly_collides(regions[e.awaited], regions[e.ahead], larger)) << trial;
        }
    }
    EXPECT_GT(by_head, 30);
}

TEST(Ends, AsATable) {
    const SequenceResult r = sequence(towers_apart(10), {});
    const std::string text = table(r.graph, r.ends);
    EXPECT_EQ(text.substr(0, text.find('\n')),
              "stroke\tregion\tlayer\tz_mm\tx_mm\ty_mm\tcause\tahead\tawaited\trise_mm\tdistance_mm");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\t'), 5 * 10);
    EXPECT_NE(text.find("\tcarriage\t"), std::string::npos);
    EXPECT_NE(text.find("\t8.2\t10\n"), std::string::npos);
    EXPECT_NE(text.find("\ttop\t-\t-\t-\t-\n"), std::string::npos);
}

TEST(Budget, IsInStepsOrSeconds) {
    EXPECT_EQ(budget("400"), 400'000'000U);
    EXPECT_EQ(budget("0.5"), 500'000U);
    EXPECT_EQ(budget("10s"), 3'000'000'000U);
    EXPECT_EQ(budget("0"), 0U);
    for (const char* wrong : {"", "s", "-1", "1e9", "6000s", "nan", "ten", "5 s", "inf"})
        EXPECT_THROW(static_cast<void>(budget(wrong)), Error) << wrong;
}

} // namespace
} // namespace filum::sequence
