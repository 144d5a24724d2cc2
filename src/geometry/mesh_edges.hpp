// Finds the two faces of every edge: half-edges that join the same two vertices meet in a bucket.
//
// A corner h of a face stands for the half-edge from it to the next corner. Half-edges are put in
// the bucket of their smaller vertex (a counting sort). While a bucket is emptied, a slot for each
// larger vertex remembers the half-edges that came first, so that each is looked at a fixed number
// of times, whatever the valence of its vertices.
#pragma once

#include "geometry/mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace knotwork {

/// Two faces that go along the same edge in the same direction, as every three do.
struct EdgeClash {
    std::uint32_t v0 = 0;
    std::uint32_t v1 = 0;
    std::size_t firstCorner = 0;
    std::size_t secondCorner = 0;
};

struct MatchedEdges {
    std::vector<MeshEdge> edges;
    std::vector<std::uint32_t> cornerEdges;
    std::optional<EdgeClash> clash{};
};

/// Does not count steps; the tests' does.
struct NoTally {
    void step() noexcept {}
};

template <class Tally = NoTally>
class EdgeMatcher {
public:
    EdgeMatcher(const FaceRows& faces, std::size_t vertices, Tally& tally)
        : faces_(faces), vertices_(vertices), tally_(tally) {}

    /// Of faces whose vertices exist and differ. With a clash, there are no edges.
    [[nodiscard]] MatchedEdges match() {
        fillBuckets();
        MatchedEdges matched;
        matched.cornerEdges.resize(faces_.corners.size());
        matched.clash = meet(matched.cornerEdges);
        if (!matched.clash) number(matched);
        return matched;
    }

private:
    /// A half-edge in the bucket of its smaller vertex.
    struct Entry {
        std::uint32_t corner = 0;
        std::uint32_t larger : 31;
        std::uint32_t ascending : 1;  ///< whether it begins at the smaller vertex
    };
    /// The first half-edges of the bucket of `smaller` to a larger vertex, one each way.
    struct Slot {
        std::uint32_t smaller = noFace;
        std::uint32_t corner[2] = {noFace, noFace};
    };

    /// Calls visit(corner, face, from, to) for every half-edge, walking along the faces.
    template <class Visit>
    void walk(Visit visit) {
        const std::size_t count = faces_.count();
        for (std::size_t face = 0, begin = 0; face < count; ++face) {
            const std::size_t end = faces_.begin(face + 1);
            for (std::size_t corner = begin; corner < end; ++corner) {
                tally_.step();
                const std::size_t next = corner + 1 < end ? corner + 1 : begin;
                visit(corner, face, faces_.corners[corner], faces_.corners[next]);
            }
            begin = end;
        }
    }

    void fillBuckets() {
        starts_.assign(vertices_ + 1, 0);
        walk([this](std::size_t, std::size_t, std::uint32_t from, std::uint32_t to) {
            ++starts_[std::min(from, to) + 1];
        });
        for (std::size_t v = 0; v < vertices_; ++v) {
            tally_.step();
            starts_[v + 1] += starts_[v];
        }
        entries_.resize(faces_.corners.size());
        // Filling moves each start to the end of its bucket, which is where the next one begins.
        walk([this](std::size_t corner, std::size_t, std::uint32_t from, std::uint32_t to) {
            Entry& entry = entries_[starts_[std::min(from, to)]++];
            entry.corner = static_cast<std::uint32_t>(corner);
            entry.larger = std::max(from, to) & 0x7fffffffU;
            entry.ascending = from < to ? 1U : 0U;
        });
    }

    /// Leaves at every corner its counterpart, or itself where there is none.
    [[nodiscard]] std::optional<EdgeClash> meet(std::vector<std::uint32_t>& counterparts) {
        std::vector<Slot> slots(vertices_);
        std::size_t at = 0;
        for (std::uint32_t smaller = 0; smaller < vertices_; ++smaller) {
            for (; at < starts_[smaller]; ++at) {
                tally_.step();
                const Entry& entry = entries_[at];
                Slot& slot = slots[entry.larger];
                if (slot.smaller != smaller) slot = {smaller, {noFace, noFace}};
                std::uint32_t& own = slot.corner[entry.ascending];
                const std::uint32_t other = slot.corner[1 - entry.ascending];
                if (own != noFace) return EdgeClash{smaller, entry.larger, own, entry.corner};
                own = entry.corner;
                counterparts[own] = own;
                if (other == noFace) continue;
                counterparts[own] = other;
                counterparts[other] = own;
                ++paired_;
            }
        }
        return std::nullopt;
    }

    /// Turns counterparts into edges, in place: those of earlier corners have their numbers.
    void number(MatchedEdges& matched) {
        matched.edges.reserve(faces_.corners.size() - paired_);
        std::vector<std::uint32_t>& numbers = matched.cornerEdges;
        walk([&](std::size_t corner, std::size_t face, std::uint32_t from, std::uint32_t to) {
            const std::uint32_t counterpart = numbers[corner];
            if (counterpart < corner) {
                numbers[corner] = numbers[counterpart];
                matched.edges[numbers[corner]].f1 = static_cast<std::uint32_t>(face);
                return;
            }
            numbers[corner] = static_cast<std::uint32_t>(matched.edges.size());
            matched.edges.push_back({from, to, static_cast<std::uint32_t>(face), noFace});
        });
    }

    FaceRows faces_;
    std::size_t vertices_;
    Tally& tally_;
    std::vector<std::uint32_t> starts_;
    std::vector<Entry> entries_;
    std::size_t paired_ = 0;
};

}  // namespace knotwork
