// What is wrong with a half-edge table: the vocabulary of the validator and of
// the exercise that asks for one.
#pragma once

#include <compare>

/// A rule of the table that a half-edge breaks. Below, i is the half-edge,
/// j = he[i].opp and k = he[i].next; a row of the table is a number from 0 to
/// he.size() - 1, and the tip of i is he[j].vi. Each rule is reported at i
/// whenever its own condition holds, whatever else is reported; only where j
/// or k is needed to look something up and is no row, there is nothing to say.
enum class Fault {
    vertex_out_of_range,  ///< he[i].vi is negative
    face_out_of_range,    ///< he[i].fi is below -1
    next_out_of_range,    ///< k is no row of the table
    opp_out_of_range,     ///< j is no row of the table
    opp_is_itself,        ///< j == i
    opp_not_mutual,       ///< j is a row, but he[j].opp is not i
    opp_same_start,       ///< j is a row, and he[j].vi is he[i].vi; so it is
                          ///< where j == i
    next_not_at_tip,      ///< j and k are rows, but he[k].vi is not the tip
    next_changes_face,    ///< k is a row, but he[k].fi is not he[i].fi
    next_shared,          ///< k is a row, and the next of another half-edge too
    face_in_two_loops,    ///< i is the smallest half-edge of a loop along a
                          ///< face (fi is 0 or more) that has a loop with a
                          ///< smaller half-edge already; a loop goes from next
                          ///< to next back to its start, and none of its
                          ///< half-edges has a fault of next except
                          ///< next_not_at_tip
};

/// One broken rule at one half-edge.
struct Finding {
    Fault fault;
    int half_edge;

    friend auto operator<=>(const Finding&, const Finding&) = default;
};
