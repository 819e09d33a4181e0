// SPDX-License-Identifier: MIT
// Ranks the hits of the site's search. First a name spelled out, then a title or a word of
// search_words.txt, then the last part of a name: functions and types, then members. After these
// come parts of titles, then text. Sources and parameters of functions come last.
var Scorer = {
    objNameMatch: 11, objPartialMatch: 6, objPrio: {0: 15, 1: 5, 2: -5}, objPrioDefault: 0,
    title: 15, partialTitle: 7, term: 5, partialTerm: 2,

    score: ([page, title, , kind, score]) => {
        const asked = new URLSearchParams(location.search).get("q").trim();
        const alike = (name) =>
            (name === asked) + (name.toLowerCase() === asked.toLowerCase());
        if (!kind) { // a page, or a section of one
            const isSource = !/^(docs|cpp|python)\b|^[A-Za-z]+$/.test(page);
            return (isSource ? 0.1 : title.includes(" > ") ? 0.8 : 1) * score;
        }
        if (kind.includes(" parameter,"))
            return 1;
        if (alike(title))
            return 120 + alike(title);
        const [owner, name] = title.split(/::|\./).slice(-2);
        if (!name || !alike(name))
            return score;
        const onRanks = page === "cpp/distributed"; // after its namesakes
        return (/^(polydec|meshes)$/.test(owner) ? 90 : 30) + alike(name) - onRanks;
    },
};
