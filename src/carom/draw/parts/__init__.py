"""What a picture is made of, decided once for every painter."""
