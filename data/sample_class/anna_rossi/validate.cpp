#include "exercises/00_table/validate.h"

// una riga esiste se l'indice è tra 0 e n-1
static bool esiste(int k, int n) { return k >= 0 && k < n; }

std::vector<Finding> validate(const HalfEdgeTable& he)
{
    const int n = he.size();
    std::vector<Finding> errori;

    // quante half-edge hanno come next la riga k
    std::vector<int> entranti(n, 0);
    for (int i = 0; i < n; i++)
        if (esiste(he[i].next, n)) entranti[he[i].next]++;

    for (int i = 0; i < n; i++) {
        const HalfEdge h = he[i];
        auto segna = [&](Fault f) { errori.push_back(Finding{f, i}); };

        if (h.vi < 0) segna(Fault::vertex_out_of_range);
        if (h.fi < -1) segna(Fault::face_out_of_range);

        bool next_ok = esiste(h.next, n);
        bool opp_ok = esiste(h.opp, n);
        if (!next_ok) segna(Fault::next_out_of_range);
        if (!opp_ok) segna(Fault::opp_out_of_range);

        if (opp_ok) {
            const HalfEdge o = he[h.opp];
            if (h.opp == i) segna(Fault::opp_is_itself);
            if (o.opp != i) segna(Fault::opp_not_mutual);
            if (o.vi == h.vi) segna(Fault::opp_same_start);
        }
        if (next_ok) {
            const HalfEdge s = he[h.next];
            if (opp_ok && s.vi != he[h.opp].vi) segna(Fault::next_not_at_tip);
            if (s.fi != h.fi) segna(Fault::next_changes_face);
            if (entranti[h.next] > 1) segna(Fault::next_shared);
        }
    }
    return errori;
}
