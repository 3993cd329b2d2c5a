// Two hundred strokes as hands and mice give them, the same at every run. In pixels, tolerance 2.
#pragma once

#include "core/geometry/vector.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace fff::test {

struct CorpusStroke
{
    std::string family;
    std::string name;
    std::vector<Vec2> samples;
    /// Segments of the closed contour that a hand would draw; 0: no known answer.
    int handCount = 0;
};

inline constexpr double kCorpusTolerance = 2.0;

class StrokeCorpus
{
public:
    static std::vector<CorpusStroke> make()
    {
        StrokeCorpus corpus;
        corpus.circles();
        corpus.ellipses();
        corpus.rectangles();
        corpus.polygons();
        corpus.roundedSquares();
        corpus.cornered();
        corpus.zigzags();
        corpus.spirals();
        corpus.noisyHands();
        corpus.wildLoops();
        corpus.outlines();
        corpus.tiny();
        corpus.huge();
        corpus.broken();
        return corpus.m_strokes;
    }

private:
    using Line = std::vector<Vec2>;
    static constexpr double kPi = std::numbers::pi;

    double any(double low, double high)
    {
        // Not a distribution of the library: those differ between libraries.
        return low + (high - low) * (static_cast<double>(m_random() >> 5) / 134217728.0);
    }
    double normal()
    {
        double sum = 0.0;
        for (int i = 0; i < 12; ++i)
            sum += any(0.0, 1.0);
        return sum - 6.0;
    }

    Vec2 normalPoint()
    {
        const double y = normal(),
                     x = normal(); // one after the other: of arguments no order is set
        return {x, y};
    }

    static Line dense(const std::function<Vec2(double)> &at, int count = 4000)
    {
        Line line;
        for (int i = 0; i <= count; ++i)
            line.push_back(at(double(i) / count));
        return line;
    }
    static Line turned(const Line &line, double angle, const Vec2 &to)
    {
        const Vec2 x(std::cos(angle), std::sin(angle));
        Line result;
        for (const Vec2 &p : line)
            result.push_back(to + p.x() * x + p.y() * perpendicular(x));
        return result;
    }

    struct Hand
    {
        double rate = 120.0;  // Hz
        double speed = 400.0; // px/s
        double waver = 0.5;   // of the speed
        double jitter = 0.0;  // px
        bool isRounded = false;
        bool isCareful = false; // slows down at corners
    };
    Hand careful(Hand hand)
    {
        hand.isCareful = true;
        return hand;
    }
    Hand anyHand(double jitter)
    {
        return {any(60.0, 240.0), any(150.0, 900.0), any(0.0, 0.7), jitter, m_random() % 2 == 0};
    }

    /// Where the pointer is at each tick on its way along the line.
    Line drawn(const Line &line, const Hand &hand)
    {
        std::vector<double> along{0.0};
        for (std::size_t i = 1; i < line.size(); ++i)
            along.push_back(along.back() + (line[i] - line[i - 1]).norm());
        Line samples;
        const double phase = any(0.0, 2.0 * kPi);
        std::size_t i = 0;
        for (double s = 0.0, t = 0.0;; t += 1.0 / hand.rate) {
            const double end = std::min(s, along.back());
            while (i + 2 < line.size() && along[i + 1] < end)
                ++i;
            const double gap = along[i + 1] - along[i];
            const double u = gap > 0.0 ? (end - along[i]) / gap : 1.0;
            Vec2 p = line[i] + u * (line[i + 1] - line[i]);
            p += hand.jitter * normalPoint();
            if (hand.isRounded)
                p = p.array().round().matrix();
            samples.push_back(p);
            if (s >= along.back())
                break;
            double step = hand.speed * (1.0 + hand.waver * std::sin(phase + 4.0 * t)) / hand.rate;
            if (hand.isCareful)
                step =
                    std::min(step, std::max(1.0, 0.5 * std::min(s - along[i], along[i + 1] - s)));
            s += step;
        }
        return samples;
    }
    void add(const std::string &family, Line samples, int handCount = 0)
    {
        m_strokes.push_back(
            {family, family + " " + std::to_string(++m_number), std::move(samples), handCount});
    }

    /// Closed exactly, or with a small gap, or a bit further than once round.
    double onceRound() { return m_number % 3 == 0 ? 1.0 : m_number % 3 == 1 ? 0.985 : 1.01; }

    Line arc(double rx, double ry, double round)
    {
        const double start = any(0.0, 2.0 * kPi);
        return dense([=](double t) {
            const double angle = start + 2.0 * kPi * round * t;
            return Vec2(rx * std::cos(angle), ry * std::sin(angle));
        });
    }
    void circles()
    {
        m_number = 0;
        for (int i = 0; i < 20; ++i) {
            const double radius = 15.0 + 12.0 * i;
            const Hand hand = anyHand(0.1 * (i % 4));
            add("circle", drawn(turned(arc(radius, radius, onceRound()), 0.0, {400, 300}), hand),
                4);
        }
    }
    void ellipses()
    {
        m_number = 0;
        for (int i = 0; i < 14; ++i) {
            const double r = 40.0 + 12.0 * i;
            const Hand hand = anyHand(0.1 * (i % 4));
            const double turn = any(0.0, kPi), round = onceRound(), share = any(0.4, 0.9);
            add("ellipse", drawn(turned(arc(r, r * share, round), turn, {400, 300}), hand), 4);
        }
    }
    /// Along the corners, from a point between two of them or from a corner, round and back.
    Line polygonLine(const Line &corners, double start)
    {
        const std::size_t n = corners.size();
        const Vec2 first = corners[0] + start * (corners[1] - corners[0]);
        Line line{first};
        for (std::size_t i = 1; i <= n; ++i)
            line.push_back(corners[i % n]);
        if (start > 0.0)
            line.push_back(first);
        return line;
    }
    void rectangles()
    {
        m_number = 0;
        for (int i = 0; i < 16; ++i) {
            const double w = any(60.0, 500.0), h = any(50.0, 300.0);
            const Line corners =
                turned({{0, 0}, {w, 0}, {w, h}, {0, h}}, i % 2 ? any(0.0, kPi) : 0.0, {300, 200});
            const Hand hand = careful(anyHand(0.1 * (i % 4)));
            const double start = i % 4 == 0 ? 0.0 : any(0.2, 0.8);
            add("rectangle", drawn(polygonLine(corners, start), hand), 4);
        }
    }
    void polygons()
    {
        m_number = 0;
        for (int i = 0; i < 16; ++i) {
            const int n = 3 + i % 6;
            Line corners;
            const double radius = any(80.0, 250.0), turn = any(0.0, kPi);
            for (int k = 0; k < n; ++k) {
                const double angle = turn + 2.0 * kPi * k / n;
                corners.push_back(Vec2(400, 300) + radius * Vec2(std::cos(angle), std::sin(angle)));
            }
            const Hand hand = careful(anyHand(0.1 * (i % 4)));
            const double start = i % 4 == 0 ? 0.0 : any(0.2, 0.8);
            add("polygon", drawn(polygonLine(corners, start), hand), n);
        }
    }
    void roundedSquares()
    {
        m_number = 0;
        for (int i = 0; i < 10; ++i) {
            const double side = any(120.0, 400.0), r = side * any(0.12, 0.3);
            Line line;
            for (int k = 0; k < 4; ++k) {
                const Line quarter = dense(
                    [=](double t) {
                        const double angle = -kPi / 2 + t * kPi / 2;
                        return Vec2(side / 2 - r + r * std::cos(angle),
                                    -side / 2 + r + r * std::sin(angle));
                    },
                    200);
                const Line part = turned(quarter, k * kPi / 2, {400, 300});
                line.insert(line.end(), part.begin(), part.end());
            }
            line.insert(line.begin(), 0.5 * (line.back() + line.front()));
            line.push_back(line.front());
            add("rounded square", drawn(line, anyHand(0.1 * (i % 4))), 8);
        }
    }
    void cornered()
    {
        m_number = 0;
        for (int i = 0; i < 14; ++i) {
            Line corners{{400, 300}};
            double heading = any(0.0, 2.0 * kPi);
            for (int k = 3 + i % 5; k > 0; --k) {
                corners.push_back(corners.back() +
                                  any(60.0, 200.0) * Vec2(std::cos(heading), std::sin(heading)));
                heading += (k % 2 ? 1.0 : -1.0) * any(0.8, 2.2);
            }
            add("corners", drawn(corners, careful(anyHand(0.15 * (i % 4)))));
        }
    }
    void zigzags()
    {
        m_number = 0;
        for (int i = 0; i < 14; ++i) {
            Line corners;
            const double height = any(20.0, 120.0), step = any(12.0, 60.0);
            for (int k = 0; k < 5 + i; ++k)
                corners.emplace_back(100.0 + step * k, 300.0 + (k % 2 ? height : 0.0));
            add("zigzag", drawn(corners, careful(anyHand(0.15 * (i % 4)))));
        }
    }
    void spirals()
    {
        m_number = 0;
        for (int i = 0; i < 14; ++i) {
            const double turns = any(1.5, 5.0), inner = any(0.0, 20.0), outer = any(120.0, 280.0);
            const bool isLogarithmic = i % 3 == 0;
            const Line line = dense([=](double t) {
                const double r =
                    isLogarithmic ? 4.0 * std::pow(outer / 4.0, t) : inner + (outer - inner) * t;
                const double angle = 2.0 * kPi * turns * t;
                return Vec2(400 + r * std::cos(angle), 300 + r * std::sin(angle));
            });
            Line way = line;
            if (i % 2)
                std::reverse(way.begin(), way.end());
            add("spiral", drawn(way, anyHand(0.15 * (i % 4))));
        }
    }
    /// A smooth closed line through random points round a middle, with a hand's slow tremor.
    void noisyHands()
    {
        m_number = 0;
        for (int i = 0; i < 30; ++i) {
            struct Wave
            {
                double size, phase;
            };
            std::vector<Wave> waves;
            for (int k = 1; k <= 5; ++k)
                waves.push_back({any(0.0, 60.0 / k), any(0.0, 2.0 * kPi)});
            const double tremor = any(0.0, 1.0), phase = any(0.0, 6.0), r = any(100.0, 250.0);
            const Line line = dense([=](double t) {
                const double angle = 2.0 * kPi * t;
                double reach = r;
                for (std::size_t k = 0; k < waves.size(); ++k)
                    reach += waves[k].size * std::sin(double(k + 1) * angle + waves[k].phase);
                reach = std::max(reach, 25.0) + tremor * std::sin(40.0 * angle + phase);
                return Vec2(500 + reach * std::cos(angle), 400 + reach * std::sin(angle));
            });
            add("noisy hand", drawn(line, anyHand(0.2 + 0.2 * (i % 4))));
        }
    }
    void wildLoops()
    {
        m_number = 0;
        for (int i = 0; i < 20; ++i) {
            const double a = double(1 + i % 4), b = double(2 + i % 5), x = any(80.0, 300.0),
                         y = any(80.0, 300.0), phase = any(0.0, kPi), loops = any(0.7, 1.6);
            const double wobble = any(0.0, 40.0);
            const Line line = dense([=](double t) {
                const double u = 2.0 * kPi * loops * t;
                return Vec2(500 + x * std::sin(a * u + phase) + wobble * std::sin(7.0 * u),
                            400 + y * std::sin(b * u) + wobble * std::cos(5.0 * u));
            });
            add("wild loop", drawn(line, anyHand(0.15 * (i % 4))));
        }
    }
    void outlines()
    {
        m_number = 0;
        for (int i = 0; i < 5; ++i) { // leaf: two arcs that meet in tips
            const double half = any(0.4, 0.9), radius = any(150.0, 300.0);
            Line line;
            for (const double side : {1.0, -1.0}) {
                const Line arc = dense([=](double t) {
                    const double angle = half - 2.0 * half * t;
                    return Vec2(side * radius * std::sin(angle),
                                side * radius * (std::cos(angle) - std::cos(half)));
                });
                line.insert(line.end(), arc.begin(), arc.end());
            }
            const Hand hand = anyHand(0.15 * (i % 4));
            const double turn = any(0.0, 6.0);
            add("leaf", drawn(turned(line, turn, {400, 300}), hand), 4);
        }
        m_number = 0;
        for (int i = 0; i < 5; ++i) { // heart
            const double size = any(6.0, 16.0);
            const Line line = dense([=](double t) {
                const double u = 2.0 * kPi * t;
                return Vec2(400 + size * 16.0 * std::pow(std::sin(u), 3.0),
                            300 + size * (13.0 * std::cos(u) - 5.0 * std::cos(2 * u) -
                                          2.0 * std::cos(3 * u) - std::cos(4 * u)));
            });
            add("heart", drawn(line, anyHand(0.15 * (i % 4))));
        }
        m_number = 0;
        for (int i = 0; i < 5; ++i) { // hand: five fingers
            const double length = any(80.0, 140.0);
            const Line line = dense([=](double t) {
                const double angle = -0.3 + (kPi + 0.6) * t;
                const double finger = std::pow(std::abs(std::sin(5.0 * kPi * t)), 0.7);
                const double r = 120.0 + length * finger;
                return Vec2(400 + r * std::cos(angle), 300 + r * std::sin(angle));
            });
            add("hand", drawn(line, anyHand(0.15 * (i % 4))));
        }
    }
    void tiny()
    {
        m_number = 0;
        for (int i = 0; i < 10; ++i) {
            const double r = any(1.0, 12.0);
            const Hand hand = anyHand(0.1 * (i % 4));
            const double round = onceRound(), share = any(0.5, 1.0);
            add("tiny", drawn(turned(arc(r, r * share, round), 0.0, {10, 10}), hand));
        }
    }
    void huge()
    {
        m_number = 0;
        for (int i = 0; i < 6; ++i) {
            const double r = any(3000.0, 20000.0);
            Hand hand = anyHand(0.5);
            hand.speed = r * 2.0;
            const double round = onceRound(), share = any(0.5, 1.0);
            add("huge", drawn(turned(arc(r, r * share, round), 0.0, {1e4, -2e4}), hand));
        }
    }
    /// What broken devices and odd hands give.
    void broken()
    {
        m_number = 0;
        Hand slow{240.0, 60.0, 0.7, 0.5, false}; // thousands of samples, trembling
        add("broken", drawn(arc(150, 100, 1.0), slow));
        Line repeated;
        Hand hand = anyHand(0.2);
        for (const Vec2 &p : drawn(arc(90, 60, 0.99), hand))
            repeated.insert(repeated.end(), 4, p);
        add("broken", repeated);
        Line back; // two steps on, one back
        const Line way = drawn(arc(120, 80, 1.0), {200.0, 500.0, 0.3, 0.3, false});
        for (std::size_t i = 0; i + 2 < way.size(); ++i) {
            back.push_back(way[i]);
            back.push_back(way[i + 2]);
            back.push_back(way[i + 1]);
        }
        add("broken", back);
        add("broken", drawn({{0, 0}, {300, 0}, {0, 0}, {300, 1}, {0, 80}}, anyHand(0.3)));
        add("broken", {{0, 0}, {900, 10}, {850, 700}, {20, 600}, {5, 20}}); // five samples
        add("broken", drawn(dense([](double t) {                            // cusps
                                const double u = 6.0 * kPi * t;
                                return Vec2(100 + 30 * (u - std::sin(u)),
                                            300 - 60 * (1 - std::cos(u)));
                            }),
                            anyHand(0.2)));
        Line halts; // stops for a second at four places
        hand = anyHand(0.3);
        for (const Vec2 &p : drawn(arc(140, 110, 1.0), hand)) {
            halts.push_back(p);
            if (halts.size() % 40 == 7)
                for (int k = 0; k < 120; ++k)
                    halts.push_back(p + 0.5 * normalPoint());
        }
        add("broken", halts);
    }

    std::mt19937 m_random{20140806};
    std::vector<CorpusStroke> m_strokes;
    int m_number = 0;
};

} // namespace fff::test
